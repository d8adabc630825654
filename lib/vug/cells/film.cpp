// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/cells/film.h>

#include <bit>
#include <cstdint>

namespace vug::cells {

double kinematic_viscosity(double t) {
  // Vogel: mu = exp(A + B / (C + T)) mPa s with T in kelvin.
  return 1e-6 * maths::exp(-3.7188 + 578.919 / (t + 273.15 - 137.546));
}

// Halley's iteration from a guess that divides the exponent by three (within 6 %); the error of a
// round is about the cube of the one before.
double cube_root(double x) {
  if (!(x > 1e-300)) return 0;
  double root = std::bit_cast<double>(std::bit_cast<uint64_t>(x) / 3 + 0x2A9F7893782DA1CEull);
  for (int round = 0; round < 2; ++round) {
    const double cube = root * root * root;
    root *= (cube + 2 * x) / (2 * cube + x);
  }
  return root;
}

double film_thickness(double flow, double steepness, double viscosity) {
  return flow > 0 ? cube_root(3 * viscosity * flow / (kGravity * steepness)) : 0;
}

double film_speed(double flow, double steepness, double viscosity) {
  return cube_root(kGravity * steepness * flow * flow / (3 * viscosity));
}

}  // namespace vug::cells
