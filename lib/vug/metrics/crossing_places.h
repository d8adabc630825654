// SPDX-License-Identifier: Apache-2.0
// Where a mesh intersects itself.
#pragma once

#include <vug/mesh/self_intersections.h>

namespace vug::metrics {

/// A connected group of intersecting triangles.
struct CrossingPlace {
  Vec3d centre;     ///< The centre of the bounding box of the triangles, metres.
  double size = 0;  ///< Longest edge of that box, metres.
  size_t pairs = 0;

  bool operator==(const CrossingPlace&) const = default;
};

/// The groups that pairs of triangles form, those with the most pairs first.
std::vector<CrossingPlace> crossing_places(const mesh::Mesh& mesh,
                                           const std::vector<mesh::FacePair>& pairs);

/// The number of triangles in the pairs.
size_t crossing_triangles(const std::vector<mesh::FacePair>& pairs);

}  // namespace vug::metrics
