// SPDX-License-Identifier: Apache-2.0
// A tangent frame for every cell, so that rules can access the neighbour in a direction, such as
// above. The paper leaves this open (gobron2006, section 4.4): its cells know their neighbours but
// not their directions.
#pragma once

#include <vug/cells/network.h>

#include <cmath>
#include <optional>

namespace vug::cells {

/// Computes `right`. On slopes of more than 18 degrees it is horizontal, up x normal: seen from
/// outside it points to the right, and `ahead` points straight up the slope. Floors and ceilings
/// have no such direction; they inherit it from the surrounding slopes, link by link without twist
/// (parallel transport), followed by smoothing. A component without slopes starts with the x axis.
/// Around a peak or a pit there is always a point where frames disagree (the hairy ball theorem).
void orient(Network& network);

/// Tangents that complete a right-handed frame with a normal.
struct Tangents {
  Vec3f right, ahead;
};

/// Tangents that depend on the normal alone, unlike those of `orient`.
inline Tangents tangents_of(const Vec3f& normal) {
  const Vec3f helper = std::fabs(normal.y) < 0.9f ? Vec3f(0, 1, 0) : Vec3f(1, 0, 0);
  const Vec3f right = helper.cross(normal).normalized();
  return {right, normal.cross(right)};
}

/// Transports a tangent vector from a point with normal `from` to one with normal `to`, by the
/// smallest rotation of the normal.
inline Vec3f parallel_transport(const Vec3f& v, const Vec3f& from, const Vec3f& to) {
  const float sum = 1 + from.dot(to);
  return sum > 1e-6f ? v - (from + to) * (v.dot(to) / sum) : v;
}

/// The neighbour whose direction, projected onto the tangent plane, is nearest to `direction` (any
/// length). Nothing if none lies within 60 degrees, or if `direction` is perpendicular to the
/// plane. (0, 1, 0) selects the uphill neighbour, -wind the upwind one.
std::optional<uint32_t> neighbour_toward(const Network& network, uint32_t cell,
                                         const Vec3f& direction);

enum class Side { right, up, left, down };
/// Selects a neighbour by a side of the cell's frame; up is `ahead`.
std::optional<uint32_t> neighbour_at(const Network& network, uint32_t cell, Side side);

}  // namespace vug::cells
