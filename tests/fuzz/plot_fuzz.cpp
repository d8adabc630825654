// SPDX-License-Identifier: Apache-2.0
// For any corners: a polygon that is not simple is rejected as bad input; a simple polygon has an
// area, contains points, and its sides are at the given positions.
#include "require.h"
#include "target.h"

#include <vug/base/error.h>
#include <vug/flora/plot.h>

#include <cmath>
#include <cstring>

namespace {

using namespace vug;

/// A number of a small grid, on which corners coincide and sides touch, or the value of any eight
/// bytes.
double coordinate(const uint8_t*& at, const uint8_t* end) {
  const uint8_t which = at == end ? uint8_t{0} : *at++;
  if (which < 240) return (which % 16) * 0.25;
  uint64_t bits = 0;
  for (int i = 0; i < 8; ++i) bits = bits << 8 | (at == end ? uint8_t{0} : *at++);
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

}  // namespace

VUG_FUZZ_TARGET(plot) {
  if (size > 400) return;
  const uint8_t* const end = data + size;
  flora::Corners corners;
  while (data != end) {
    const double x = coordinate(data, end);
    corners.emplace_back(x, coordinate(data, end));
  }
  try {
    const flora::Plot plot(corners);
    require(plot.area() > 0 && std::isfinite(plot.area()), "a plot has an area");
    require(plot.first_reflex_corner() < static_cast<int>(corners.size()),
            "a reflex corner is a corner");
    double turned = 0;  // twice the area, from the first corner
    for (size_t i = 0; i < corners.size(); ++i)
      turned += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
    const double extent = (plot.high() - plot.low()).length2();
    require(std::fabs(std::fabs(turned) / 2 - plot.area()) <= 1e-6 * extent, "triangles fill it");
    RandomStream random(RandomKey(1));
    for (int i = 0; i < 8; ++i) {
      const Vec2d p = plot.point(random);
      const double reach = 1e-6 * std::sqrt(extent);
      require(p.x >= plot.low().x - reach && p.x <= plot.high().x + reach &&
                  p.y >= plot.low().y - reach && p.y <= plot.high().y + reach,
              "points lie in the box");
      require(plot.contains(p) || plot.border_distance(p) <= reach, "points lie inside");
    }
  } catch (const Error& error) {
    require(error.code() == ErrorCode::bad_input, "errors blame the corners");
  }
}
