// A plot of ground: a simple polygon in the plane, in which plants are set out.
#pragma once

#include <vug/base/rng.h>
#include <vug/base/vec.h>

#include <array>
#include <vector>

namespace vug::flora {

/// The x and the y of a Vec2d are metres along the x and the z of a scene.
using Corners = std::vector<Vec2d>;

/// Immutable. A point of it is as likely anywhere: the polygon is cut into triangles (constrained
/// Delaunay, see mesh::add_rings), which are chosen by their areas.
class Plot {
 public:
  /// Corners in order, turning either way. Error(bad_input), telling where: fewer than three,
  /// numbers that are not finite or beyond 1e6 m, a corner that is there twice, sides that cross or
  /// touch, no area.
  explicit Plot(Corners corners);

  const Corners& corners() const { return corners_; }
  double area() const { return total_.back(); }  ///< Square metres.
  const Vec2d& low() const { return low_; }      ///< Of the box around it.
  const Vec2d& high() const { return high_; }
  /// Whether the point lies inside; of its border about half.
  bool contains(const Vec2d& p) const;
  /// Metres to the nearest side, from within or without.
  double border_distance(const Vec2d& p) const;
  /// A point spread evenly over the plot; takes three numbers of the stream.
  Vec2d point(RandomStream& random) const;
  /// The first corner that turns the other way than the polygon does, by more than rounding; -1
  /// where it is convex.
  int first_reflex_corner() const;

 private:
  Corners corners_;
  Vec2d low_, high_;
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<double> total_;  ///< Areas of all triangles up to each.
};

/// "(1.5, -2)": for messages.
std::string to_string(const Vec2d& point);

}  // namespace vug::flora
