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
/// The share of the excess of calcium that a stalactite takes at most at a time. Its volume grows
/// with the age to the power 5/2 until then, and in proportion to the age from then on.
constexpr double kMostTaken = 0.8, kVolumePower = 2.5;
/// Straws grow faster than stalagmites, because their rim is narrow (our choice).
constexpr double kStrawHaste = 2;
constexpr int kBisections = 40;

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
  // The mean over the age, which is proportional to the age to the power 3/2.
  double taken = volume / (kCalciteVolume * passed);
  const double most = kMostTaken * excess, free = most / kVolumePower;
  if (taken > free) {
    const double early = maths::pow(free / taken, 1 / (kVolumePower - 1));  // A share of the age.
    const double limited = free * early + most * (1 - early);
    out.length *= maths::pow(limited / taken, 1 / kVolumePower);
    taken = limited;
  }
  out.calcium = water.calcium - taken;
  return out;
}

double straw_length(const Water& water, double interval, double longest) {
  const double rate = kStrawHaste * growth_rate(water.calcium, water.temperature, interval);
  return longest * (1 - maths::exp(-rate * water.age / longest));
}

StalactiteGrowth DripGrowth::hanging(const Water& water) const {
  if (straw) return {straw_length(water, interval, *straw), water.calcium};
  return grow_stalactite(water, interval, *curve);
}

double DripGrowth::standing_height(const Water& water) const {
  return growth_rate(hanging(water).calcium, water.temperature, interval) * water.age;
}

std::optional<Meeting> meeting_of(const DripGrowth& growth, const Water& water, double gap) {
  const auto at = [&](double share) {
    Water then = water;
    then.age *= share;
    return then;
  };
  const auto reach = [&](double share) {
    return growth.hanging(at(share)).length + growth.standing_height(at(share));
  };
  if (!(reach(1) >= gap)) return std::nullopt;
  double apart = 0, together = 1;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (apart + together);
    (reach(middle) < gap ? apart : together) = middle;
  }
  return Meeting{together, growth.standing_height(at(together))};
}

}  // namespace vug::drips
