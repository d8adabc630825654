// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/vec.h>
#include <vug/drips/chemistry.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::drips {
namespace {

constexpr double kFilm = 1e-4;  // The thickness of the film in metres.

/// Values at 5, 10, 15 and 20 degrees, from the equilibria of calcite, water and carbon dioxide.
constexpr double kFirst = 5, kStep = 5;
constexpr std::array<double, 4> kEquilibrium = {0.811, 0.745, 0.685, 0.630};
constexpr std::array<double, 4> kOpen = {3.361, 3.079, 2.824, 2.593};
constexpr std::array<double, 4> kClosed = {1.654, 1.423, 1.232, 1.075};

/// Solubilities fall nearly exponentially with the temperature, so their logarithms are
/// interpolated, and continued beyond the ends.
double at_temperature(const std::array<double, 4>& table, double temperature) {
  const double place = (temperature - kFirst) / kStep;
  const auto i = static_cast<size_t>(std::clamp(std::floor(place), 0.0, 2.0));
  const double part = place - static_cast<double>(i);
  return maths::exp((1 - part) * maths::log(table[i]) + part * maths::log(table[i + 1]));
}

/// The share of its excess that a resting film has lost after a time: 1 - exp(-alpha t / film).
double share_lost(double temperature, double time) {
  const double x = deposition_rate(temperature) * time / kFilm;
  return x < 1e-5 ? x : 1 - maths::exp(-x);
}

}  // namespace

double deposition_rate(double t) { return 1e-7 * (0.51549 + 0.04015 * t + 0.00418 * t * t); }

double equilibrium_calcium(double t) { return at_temperature(kEquilibrium, t); }

double seep_calcium(double t, double mixing) {
  return (1 - mixing) * at_temperature(kOpen, t) + mixing * at_temperature(kClosed, t);
}

double growth_rate(double calcium, double t, double interval) {
  const double excess = std::max(0.0, calcium - equilibrium_calcium(t));
  return kSecondsPerYear * kCalciteVolume * excess * kFilm / interval * share_lost(t, interval);
}

double trunk_radius(double volume, double t, double interval) {
  return std::sqrt(volume / (kPi * kFilm * share_lost(t, interval)));
}

double calcium_after(double calcium, double t, double area, double discharge) {
  const double least = equilibrium_calcium(t);
  return least + (calcium - least) * maths::exp(-deposition_rate(t) * area / discharge);
}

}  // namespace vug::drips
