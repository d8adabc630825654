// SPDX-License-Identifier: Apache-2.0
// Plots and samples shared by tests of point processes.
#pragma once

#include <vug/flora/distribution.h>

namespace vug::flora {

inline Corners square(double side) { return {{0, 0}, {side, 0}, {side, side}, {0, side}}; }

/// With circumradius 1.
inline Corners hexagon() {
  const double h = std::sqrt(0.75);
  return {{1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}};
}

inline std::vector<Vec2d> draw(const std::string& name, const NamedValues& parameters,
                               const Corners& corners, double density, uint64_t seed = 1) {
  const Plot plot(corners);
  return make_product(distributions(), name, parameters)
      ->points(plot, density, RandomKey(seed), Progress::none());
}

/// The error message of sampling; empty without an error.
inline std::string fault_of(const std::string& name, const NamedValues& parameters,
                            const Corners& corners, double density) {
  try {
    draw(name, parameters, corners, density);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace vug::flora
