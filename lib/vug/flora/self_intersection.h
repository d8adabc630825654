// SPDX-License-Identifier: Apache-2.0
// Detection of self-intersecting polygons, in a plane or in space.
#pragma once

#include <vug/base/vec.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace vug::flora {

/// Two sides of a polygon, counted from 1 (side 1 leads from the first corner to the second).
struct SelfIntersection {
  size_t first = 0, second = 0;
  Vec3d at;  ///< Position in metres.
};

/// Whether sides may touch without crossing: a corner on another side, or overlapping collinear
/// sides. Adjacent sides, which share a corner, are not tested.
enum class Touching { allowed, refused };

/// Two sides that cross or, if touching is refused, touch. For polygons in an axis-aligned plane
/// touching is tested exactly. If touching is allowed, sides only cross in their interiors, by more
/// than rounding. Non-planar outlines are projected along the axis nearest to their normal, and
/// sides that pass over each other do not count. Empty if there is no intersection, or none among
/// the first 2e8 pairs of sides (a polygon of more than 20,000 corners).
std::optional<SelfIntersection> find_self_intersection(const std::vector<Vec3d>& corners,
                                                       Touching touching);

}  // namespace vug::flora
