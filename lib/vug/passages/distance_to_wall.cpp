// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/distance_to_wall.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kSmallestStep = 1e-3;  ///< Metres.
constexpr double kTolerance = 1e-6;     ///< Metres.

}  // namespace

std::optional<double> distance_to_wall(const field::Field& field, const Vec3d& from,
                                       const Vec3d& direction, double reach) {
  const double slope = std::max(field.lipschitz(), 1e-12);
  double value = field.value(from);
  const bool negative = value < 0;
  double near = 0;
  while (near < reach && std::isfinite(value)) {
    double far = std::min(near + std::max(std::abs(value) / slope, kSmallestStep), reach);
    value = field.value(from + direction * far);
    if (std::isnan(value) || (value < 0) == negative) {
      near = far;
      continue;
    }
    while (far - near > kTolerance) {
      const double middle = 0.5 * (near + far);
      ((field.value(from + direction * middle) < 0) == negative ? near : far) = middle;
    }
    return 0.5 * (near + far);
  }
  return std::nullopt;
}

}  // namespace vug::passages
