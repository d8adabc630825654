// SPDX-License-Identifier: Apache-2.0
// Plots: simple polygons in the plane in which plants are placed.
#pragma once

#include <vug/base/rng.h>
#include <vug/base/vec.h>

#include <array>
#include <vector>

namespace vug::flora {

/// The x and y of a Vec2d are metres along x and z of the scene.
using Corners = std::vector<Vec2d>;

/// Immutable. Supports uniform sampling: the polygon is triangulated (constrained Delaunay, see
/// mesh::add_rings), and triangles are chosen by area.
class Plot {
 public:
  /// Corners in either winding. Error(bad_input) with the location for fewer than three corners,
  /// coordinates that are not finite or beyond 1e6 m, duplicate corners, sides that cross or touch,
  /// or zero area.
  explicit Plot(Corners corners);

  const Corners& corners() const { return corners_; }
  double area() const { return total_.back(); }  ///< Square metres.
  const Vec2d& low() const { return low_; }      ///< Lower corner of the bounding box.
  const Vec2d& high() const { return high_; }
  /// Whether the point is inside; about half of the border counts as inside.
  bool contains(const Vec2d& p) const;
  /// Distance to the nearest side in metres, for points inside and outside.
  double border_distance(const Vec2d& p) const;
  /// A uniformly distributed point; consumes three numbers of the stream.
  Vec2d point(RandomStream& random) const;
  /// The first corner that turns against the polygon's winding by more than rounding; -1 for a
  /// convex polygon.
  int first_reflex_corner() const;

 private:
  Corners corners_;
  Vec2d low_, high_;
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<double> total_;  ///< Cumulative areas of the triangles.
};

/// Formats a point for messages: "(1.5, -2)".
std::string to_string(const Vec2d& point);

}  // namespace vug::flora
