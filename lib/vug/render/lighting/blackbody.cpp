// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/render/lighting/blackbody.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::render {
namespace {

/// Colour and log luminance at even steps of 1 / temperature, where both are nearly linear.
struct ThermalTable {
  static constexpr size_t kSteps = 1024;
  static constexpr double kHottest = 40000, kCoolest = 300;
  static constexpr double kFirst = 1 / kHottest, kStep = (1 / kCoolest - kFirst) / (kSteps - 1);
  std::array<Rgb, kSteps> colour{};
  std::array<double, kSteps> log_luminance{};

  ThermalTable() {
    constexpr double kFirstRadiation = 1.191042972e-16;  // 2 h c^2 in W m^2 / sr
    constexpr double kWave = 560e-9, kSpacing = 5e-9;    // metres
    for (size_t i = 0; i < kSteps; ++i) {
      const double temperature = 1 / (kFirst + kStep * static_cast<double>(i));
      const double planck = kFirstRadiation / maths::pow(kWave, 5) /
                            (maths::exp(kSecondRadiation / (560 * temperature)) - 1);
      colour[i] = Rgb(blackbody(temperature));
      log_luminance[i] =
          maths::log(683 / kLumenPerWatt * blackbody_xyz(temperature).y * planck * kSpacing);
    }
  }
};

}  // namespace

Rgb thermal_radiance(float temperature) {
  static const ThermalTable table;
  using T = ThermalTable;
  if (!(static_cast<double>(temperature) > T::kCoolest)) return Rgb(0.0f);
  const double place = std::max(0.0, (1 / static_cast<double>(temperature) - T::kFirst) / T::kStep);
  const auto i = std::min(static_cast<size_t>(place), T::kSteps - 2);
  const double part = place - static_cast<double>(i);
  const double luminance =
      maths::exp(table.log_luminance[i] * (1 - part) + table.log_luminance[i + 1] * part);
  const auto share = static_cast<float>(part);
  return (table.colour[i] * (1 - share) + table.colour[i + 1] * share) *
         static_cast<float>(luminance);
}

}  // namespace vug::render
