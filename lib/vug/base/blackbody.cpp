// SPDX-License-Identifier: Apache-2.0
#include <vug/base/blackbody.h>
#include <vug/base/maths.h>

#include <algorithm>

namespace vug {
namespace {

/// Piecewise Gaussian around `middle` in nm; `below` and `above` are the inverse widths on either
/// side.
double bell(double x, double middle, double below, double above) {
  const double t = (x - middle) * (x < middle ? below : above);
  return maths::exp(-0.5 * t * t);
}

}  // namespace

Vec3d blackbody_xyz(double temperature) {
  Vec3d xyz(0.0);
  for (double nm = 380; nm <= 780; nm += 5) {
    // Relative to the value at 560 nm to avoid overflow.
    const double ratio = 560 / nm, square = ratio * ratio;
    const double planck = square * square * ratio *
                          (maths::exp(kSecondRadiation / (560 * temperature)) - 1) /
                          (maths::exp(kSecondRadiation / (nm * temperature)) - 1);
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

Vec3d blackbody(double temperature) {
  const Vec3d xyz = blackbody_xyz(temperature);
  const auto positive = [](double v) { return std::max(v, 0.0); };
  const Vec3d rgb(positive(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z),
                  positive(-0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z),
                  positive(0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z));
  return rgb / (0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z);
}

}  // namespace vug
