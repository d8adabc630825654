// Polygons whose outline meets itself, in a plane or in space.
#pragma once

#include <vug/base/vec.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace vug::flora {

/// Two sides of a polygon, counted from 1 (side 1 leads from the first corner to the second).
struct SelfIntersection {
  size_t first = 0, second = 0;
  Vec3d at;  ///< Metres.
};

/// Whether sides may meet without going through each other: a corner on another side, sides that
/// run along one another. Of neighbours, which share a corner, nothing is asked.
enum class Touching { allowed, refused };

/// Two sides that go through each other or, where that is refused, touch. In a plane that an axis
/// is normal to touching is told exactly. Where it is allowed sides cross within their ends, by
/// more than rounding does. Outlines that are not plane are looked at along the axis next to their
/// normal, and sides that pass over each other are no fault. Nothing where there is none, or where
/// it was not found among 2e8 pairs of sides (a polygon of more than 20,000 corners).
std::optional<SelfIntersection> find_self_intersection(const std::vector<Vec3d>& corners,
                                                       Touching touching);

}  // namespace vug::flora
