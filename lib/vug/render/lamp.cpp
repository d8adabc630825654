#include <vug/base/maths.h>
#include <vug/render/lamp.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

double luminance_of(const Vec3d& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

/// A bell with other widths below and above its middle, in nm.
double bell(double x, double middle, double below, double above) {
  const double t = (x - middle) * (x < middle ? below : above);
  return maths::exp(-0.5 * t * t);
}

}  // namespace

Vec3d blackbody(double temperature) {
  constexpr double kSecond = 1.438776877e7;  // hc/k in nm K
  Vec3d xyz(0.0);
  for (double nm = 380; nm <= 780; nm += 5) {
    // Relative to the value at 560 nm, so that nothing overflows.
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
  const auto positive = [](double v) { return std::max(v, 0.0); };
  const Vec3d rgb(positive(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z),
                  positive(-0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z),
                  positive(0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z));
  return rgb / luminance_of(rgb);
}

std::string LampParams::fault() const {
  if (power && lumen) return "a lamp's light is told in watts or in lumen, not in both";
  if ((power || lumen) && !(luminance_of(radiance) > 0))
    return "a lamp of black radiance has no colour that could be brought to a power";
  if (!only.empty() && !except.empty()) return "a light has 'only' or 'except', not both";
  return "";
}

Vec3d LampParams::tinted() const {
  return temperature ? radiance * blackbody(*temperature) : radiance;
}

std::optional<double> LampParams::watts() const {
  if (lumen) return *lumen / kLumenPerWatt;
  return power;
}

Rgb LampParams::radiance_of(double watts_per_radiance) const {
  const Vec3d colour = tinted();
  const auto all = watts();
  return Rgb(all ? colour * (*all / (watts_per_radiance * luminance_of(colour))) : colour);
}

}  // namespace vug::render
