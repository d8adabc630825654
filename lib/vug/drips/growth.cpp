// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/drips/chemistry.h>
#include <vug/drips/drop.h>
#include <vug/drips/growth.h>

#include <algorithm>

namespace vug::drips {
namespace {

constexpr double kMetre = 1;
/// Drops that hang for this time in seconds leave half of a film's deposit at the tip (our choice).
constexpr double kHalfTime = 20;
/// The share of the excess of calcium that a stalactite takes at most.
constexpr double kMostTaken = 0.8;

}  // namespace

field::StalactiteCurve common_curve(double girth) {
  return field::StalactiteCurve::fit(girth, kMetre, 0.5 * straw_diameter(10));
}

double root_radius(const field::StalactiteCurve& curve, double length, double tip) {
  const double end = curve.height_at(std::max(tip, curve.least_radius()));
  return curve.radius_at(end + length);
}

StalactiteGrowth grow_stalactite(const Water& water, double interval,
                                 const field::StalactiteCurve& curve) {
  StalactiteGrowth out;
  const double share = interval / (interval + kHalfTime);
  out.length = share * growth_rate(water.calcium, water.temperature, interval) * water.age;
  const double excess = std::max(0.0, water.calcium - equilibrium_calcium(water.temperature));
  const double passed = water.discharge * water.age * kSecondsPerYear;  // m3
  if (!(out.length > 0 && passed > 0)) return {0, water.calcium};
  // A body of revolution whose radius is proportional to the height to the power 3/4.
  const double radius = root_radius(curve, out.length, 0.5 * straw_diameter(water.temperature));
  const double volume = kPi * radius * radius * out.length / 2.5;
  double taken = volume / (kCalciteVolume * passed);
  if (taken > kMostTaken * excess) {
    out.length *= maths::pow(kMostTaken * excess / taken, 0.4);
    taken = kMostTaken * excess;
  }
  out.calcium = water.calcium - taken;
  return out;
}

}  // namespace vug::drips
