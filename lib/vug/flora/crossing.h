// Polygons in space whose outline crosses itself.
#pragma once

#include <vug/base/vec.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace vug::flora {

/// Two sides of a polygon, counted from 1 (side 1 leads from the first corner to the second).
struct Crossing {
  size_t first = 0, second = 0;
  Vec3d at;  ///< Metres.
};

/// Two sides that go through each other, each within its ends: sides that only touch, or run back
/// along one another, do not. Outlines that are not plane are looked at along their normal, and
/// sides that pass over each other are no fault. Nothing where there is none, or where it was not
/// found among 2e8 pairs of sides (a polygon of more than 20,000 corners).
std::optional<Crossing> self_crossing(const std::vector<Vec3d>& corners);

}  // namespace vug::flora
