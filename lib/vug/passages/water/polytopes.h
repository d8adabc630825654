// SPDX-License-Identifier: Apache-2.0
// The union of convex polytopes as a field: the bodies of water and sediment.
#pragma once

#include <vug/field/field.h>

#include <string>
#include <vector>

namespace vug::passages {

/// The points with normal . p <= offset in scene space; the normal is a unit vector.
struct HalfSpace {
  Vec3d normal{0, 1, 0};
  double offset = 0;
};

/// The intersection of the half spaces and of the box.
struct Polytope {
  std::vector<HalfSpace> faces;
  Box3d box;
};

/// min over the polytopes of max over their faces and the sides of their boxes, in metres: a lower
/// bound of the distance, exact next to faces, with the Lipschitz constant 1. A BVH of the boxes
/// finds the minimum. Polytopes that share a face must overlap, or the field is 0 on it. Without
/// polytopes, the field is empty.
field::Field polytopes(std::string name, std::vector<Polytope> parts);

}  // namespace vug::passages
