// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/srgb.h>

#include <algorithm>

namespace vug {

double srgb_encode(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * maths::pow(v, 1 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
  const double v = std::clamp(encoded, 0.0, 1.0);
  return v <= 0.04045 ? v / 12.92 : maths::pow((v + 0.055) / 1.055, 2.4);
}

}  // namespace vug
