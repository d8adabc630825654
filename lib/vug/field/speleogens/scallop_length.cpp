// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/speleogens/scallop_length.h>

#include <cmath>

namespace vug::field {
namespace {

constexpr double kReynolds = 2200;  // Of the friction velocity and the length (blumberg1974).
constexpr double kRoughWall = 9.4;  // B_L of the law of the wall, ditto.
constexpr double kShortest = 1e-6;

}  // namespace

double scallop_velocity(double length, double diameter, double viscosity) {
  const double friction = kReynolds * viscosity / length;
  return friction * (2.5 * (maths::log(diameter / (2 * length)) - 1.5) + kRoughWall);
}

std::optional<double> scallop_length(double velocity, double diameter, double viscosity) {
  double low = kShortest, high = 0.5 * diameter;  // The velocity falls with the length.
  if (!(low < high) || !(scallop_velocity(high, diameter, viscosity) <= velocity) ||
      !(scallop_velocity(low, diameter, viscosity) >= velocity))
    return std::nullopt;
  for (int i = 0; i < 100; ++i) {
    const double middle = std::sqrt(low * high);
    (scallop_velocity(middle, diameter, viscosity) > velocity ? low : high) = middle;
  }
  return low;
}

}  // namespace vug::field
