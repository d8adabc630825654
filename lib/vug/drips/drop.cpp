// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/vec.h>
#include <vug/drips/drop.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::drips {
namespace {

constexpr double kBond = 3.5;
/// Harkins and Brown's shares of a drop that detach, for the radius of the rim over the cube root
/// of the drop's volume from 0.3 in steps of 0.05.
constexpr std::array<double, 13> kDetached = {0.7256, 0.7011, 0.6828, 0.6669, 0.6515,
                                              0.6362, 0.6250, 0.6171, 0.6093, 0.6032,
                                              0.6000, 0.5992, 0.5998};

double share_detached(double ratio) {
  const double place = std::clamp((ratio - 0.3) / 0.05, 0.0, 11.999);
  const auto i = static_cast<size_t>(place);
  const double part = place - static_cast<double>(i);
  return (1 - part) * kDetached[i] + part * kDetached[i + 1];
}

/// A film cannot support drops under steeper rock; its wavelength is that at this cosine.
constexpr double kLeastCosine = 0.05;
constexpr double kStraightFall = 2, kTallFall = 20, kTallScatter = 0.05, kMostScatter = 0.1;

}  // namespace

double surface_tension(double temperature) {
  const double cold = 1 - (temperature + 273.15) / 647.096;
  return 0.2358 * maths::pow(cold, 1.256) * (1 - 0.625 * cold);
}

double straw_diameter(double temperature) {
  return std::sqrt(kBond * surface_tension(temperature) / (kWaterDensity * kGravity));
}

double drop_volume(double temperature, double diameter) {
  const double held = kPi * diameter * surface_tension(temperature) / (kWaterDensity * kGravity);
  double volume = 0.63 * held;
  for (int i = 0; i < 30; ++i)
    volume = held * share_detached(0.5 * diameter / maths::pow(volume, 1.0 / 3));
  return volume;
}

double scatter_radius(double height) {
  const double past = (height - kStraightFall) / (kTallFall - kStraightFall);
  return std::clamp(kTallScatter * past, 0.0, kMostScatter);
}

double drip_spacing(double temperature, double cosine) {
  const double capillary = std::sqrt(surface_tension(temperature) / (kWaterDensity * kGravity));
  return 2 * kPi * std::sqrt(2 / std::max(cosine, kLeastCosine)) * capillary;
}

}  // namespace vug::drips
