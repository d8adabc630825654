// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/vec.h>
#include <vug/paint/leaf_pattern.h>
#include <vug/paint/paint.h>

#include <algorithm>
#include <cmath>

namespace vug::paint {
namespace {

/// 1 at integers, falling to 0 at half a `width` from them.
double ridge(double x, double width) { return ramp(std::fabs(x - std::round(x)), width / 2, 0); }

}  // namespace

double LeafOutline::half_width(double along) const {
  if (along <= 0 || along >= 1) return 0;
  const double base = tip * widest / (1 - widest);
  return maths::pow(along / widest, base) * maths::pow((1 - along) / (1 - widest), tip);
}

bool LeafOutline::contains(const LeafPoint& at) const {
  return std::fabs(at.across) < half_width(at.along);
}

double vein_at(const LeafPoint& at, const LeafOutline& outline, const LeafVeins& veins) {
  const double half = outline.half_width(at.along), side = std::fabs(at.across);
  if (!(half > 0)) return 1;
  // The midrib tapers with the leaf, but less.
  const double rib = veins.midrib * (1 - 0.7 * at.along);
  const double middle = ramp(side, rib, 0.4 * rib);
  // Veins divide the local width, so they converge where it narrows.
  const double lane = side / half * (veins.count + 0.5);
  const double lengthwise = lane > 0.5 ? 0.5 * ridge(lane, 0.45) : 0;
  // Cross veins of neighbouring lanes are offset.
  const double lag = 0.38 * std::floor(lane + 0.5) * (at.across < 0 ? 1 : -1);
  const double crosswise =
      veins.cross_veins > 0 ? 0.2 * ridge(at.along * veins.cross_veins + lag, 0.3) : 0;
  return std::max(middle, std::max(lengthwise, crosswise));
}

}  // namespace vug::paint
