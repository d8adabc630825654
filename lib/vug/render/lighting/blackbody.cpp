// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/render/lighting/blackbody.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::render {
namespace {

constexpr double kSecond = 1.438776877e7;  // hc/k in nm K

/// Piecewise Gaussian around `middle` in nm; `below` and `above` are the inverse widths on either
/// side.
double bell(double x, double middle, double below, double above) {
  const double t = (x - middle) * (x < middle ? below : above);
  return maths::exp(-0.5 * t * t);
}

/// Tristimulus values of Planck's law, relative to its value at 560 nm.
Vec3d spectrum(double temperature) {
  Vec3d xyz(0.0);
  for (double nm = 380; nm <= 780; nm += 5) {
    // Relative to the value at 560 nm to avoid overflow.
    const double ratio = 560 / nm, square = ratio * ratio;
    const double planck = square * square * ratio *
                          (maths::exp(kSecond / (560 * temperature)) - 1) /
                          (maths::exp(kSecond / (nm * temperature)) - 1);
    const double x = 0.362 * bell(nm, 442.0, 0.0624, 0.0374) +
                     1.056 * bell(nm, 599.8, 0.0264, 0.0323) -
                     0.065 * bell(nm, 501.1, 0.0490, 0.0382);
    const double y =
        0.821 * bell(nm, 568.8, 0.0213, 0.0247) + 0.286 * bell(nm, 530.9, 0.0613, 0.0322);
    const double z =
        1.217 * bell(nm, 437.0, 0.0845, 0.0278) + 0.681 * bell(nm, 459.0, 0.0385, 0.0725);
    xyz += Vec3d(x, y, z) * planck;
  }
  return xyz;
}

Vec3d to_rgb(const Vec3d& xyz) {
  const auto positive = [](double v) { return std::max(v, 0.0); };
  const Vec3d rgb(positive(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z),
                  positive(-0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z),
                  positive(0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z));
  return rgb / luminance(rgb);
}

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
      const double planck =
          kFirstRadiation / maths::pow(kWave, 5) / (maths::exp(kSecond / (560 * temperature)) - 1);
      colour[i] = Rgb(blackbody(temperature));
      log_luminance[i] =
          maths::log(683 / kLumenPerWatt * spectrum(temperature).y * planck * kSpacing);
    }
  }
};

}  // namespace

Vec3d blackbody(double temperature) { return to_rgb(spectrum(temperature)); }

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
