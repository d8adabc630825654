// Which way is right: a tangent frame for every cell, so that rules can ask for the neighbour
// above. The paper leaves this open (gobron2006, section 4.4): its cells know who their neighbours
// are, not where.
#pragma once

#include <vug/cells/network.h>

#include <optional>

namespace vug::cells {

/// Fills `right`. On slopes of more than 18 degrees it is level, up x normal: seen from outside it
/// points to the right, and `ahead` straight up the slope. Floors and ceilings have no such way: it
/// is carried on to them from the slopes around, link by link without twist (parallel transport),
/// and evened out. A piece without slopes begins with the x axis. Turning once around a peak or a
/// pit leaves a place where frames disagree, as on any hairy ball.
void orient(Network& network);

/// A tangent vector at a place with normal `from` as it is at one with normal `to`: turned with the
/// normal by the shortest way.
inline Vec3f parallel_transport(const Vec3f& v, const Vec3f& from, const Vec3f& to) {
  const float sum = 1 + from.dot(to);
  return sum > 1e-6f ? v - (from + to) * (v.dot(to) / sum) : v;
}

/// The neighbour whose direction, seen along the tangent plane, is nearest to `way` (any length);
/// nothing when none lies within 60 degrees of it, or `way` stands on the plane. With (0, 1, 0) it
/// is the neighbour uphill, with -wind the one upwind.
std::optional<uint32_t> neighbour_toward(const Network& network, uint32_t cell, const Vec3f& way);

enum class Side { right, up, left, down };
/// The same for the sides of the cell's frame; up is `ahead`.
std::optional<uint32_t> neighbour_at(const Network& network, uint32_t cell, Side side);

}  // namespace vug::cells
