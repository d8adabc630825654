// SPDX-License-Identifier: Apache-2.0
#include <vug/field/opaque.h>
#include <vug/passages/lines/height_above_floor.h>
#include <vug/passages/lines/line_bvh.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kSlope = 4;

/// A value with the unit vector to p from the point of the line that has it.
struct Extension {
  double value = kInfinity;
  Vec3d away{0.0};
};

/// The minimum over a line of sign * floor + k * distance. With s along the line, a the slope of
/// the first term and h the distance from the line's carrier, a + k (s - s0) / sqrt(h^2 + (s -
/// s0)^2) vanishes at s0 - a h / sqrt(k^2 - a^2).
Extension extension_of(const AxisLine& line, const Vec3d& p, double sign) {
  const double length = line.vector().length();
  const Vec3d direction = line.vector() / length, offset = p - line.from;
  const double slope = sign * (line.floor_to - line.floor_from) / length;
  const double s0 = offset.dot(direction), h = (offset - direction * s0).length();
  const double steep = kSlope * kSlope - slope * slope;
  double s = slope < 0 ? length : 0;
  if (steep > 0) s = std::clamp(s0 - slope * h / std::sqrt(steep), 0.0, length);
  const Vec3d away = offset - direction * s;
  const double distance = away.length();
  return {sign * line.floor_from + slope * s + kSlope * distance,
          distance > 0 ? away / distance : Vec3d(0.0)};
}

struct AboveFloor {
  std::shared_ptr<const LineBvh> lines;

  Extension extension(const Vec3d& p, double sign) const {
    Extension best;
    lines->search(
        best.value,
        [&](const LineBvh::Node& node) {
          return (sign > 0 ? node.low : -node.high) + kSlope * node.distance(p);
        },
        [&](uint32_t, const AxisLine& line) {
          const Extension next = extension_of(line, p, sign);
          if (next.value < best.value) best = next;
        });
    return best;
  }
  field::Gradient sample(const Vec3d& p) const {
    const Extension above = extension(p, 1), below = extension(p, -1);
    return {p.y - 0.5 * (above.value - below.value),
            Vec3d(0, 1, 0) - (above.away - below.away) * (0.5 * kSlope)};
  }
};

}  // namespace

field::Field height_above_floor(std::vector<AxisLine> lines) {
  field::Traits traits;
  traits.lipschitz = 1 + kSlope;
  traits.exactness = field::Exactness::sign;
  traits.bounds = infinite_box();
  return field::Field(std::make_shared<field::OpaqueNode<AboveFloor>>(
      "height_above_floor", traits, AboveFloor{std::make_shared<const LineBvh>(std::move(lines))}));
}

}  // namespace vug::passages
