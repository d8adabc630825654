// SPDX-License-Identifier: Apache-2.0
// Where triangles of a mesh intersect others, are folded or have no area.
#pragma once

#include <vug/mesh/self_intersections.h>

namespace vug::metrics {

/// A connected group of invalid triangles.
struct InvalidPlace {
  Vec3d centre;      ///< The centre of the bounding box of the triangles, metres.
  double size = 0;   ///< Longest edge of that box, metres.
  size_t count = 0;  ///< The number of intersecting pairs, and of other invalid triangles.

  bool operator==(const InvalidPlace&) const = default;
};

/// The groups that pairs of triangles form, the largest first. A triangle that is invalid by itself
/// is a pair of equal numbers.
std::vector<InvalidPlace> invalid_places(const mesh::Mesh& mesh,
                                         const std::vector<mesh::FacePair>& pairs);

/// The number of different triangles in the pairs.
size_t invalid_triangles(const std::vector<mesh::FacePair>& pairs);

}  // namespace vug::metrics
