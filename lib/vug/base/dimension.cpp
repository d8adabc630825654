// SPDX-License-Identifier: Apache-2.0
#include <vug/base/dimension.h>

#include <cmath>

namespace vug {
namespace {

/// Exponents of metre, radian, second, kilogram, kelvin and lumen.
using Powers = std::array<int, 6>;

struct DimensionRow {
  Dimension dimension;
  const char* name;
  const char* unit;
  Powers powers;
};

/// In the order of the enumeration. A watt is kg m^2 / s^3, and a candela is a lumen per steradian.
constexpr DimensionRow kRows[] = {
    {Dimension::none, "plain number", "", {}},
    {Dimension::length, "length", "m", {1}},
    {Dimension::angle, "angle", "rad", {0, 1}},
    {Dimension::ratio, "ratio", "", {}},
    {Dimension::per_length, "number per metre", "/m", {-1}},
    {Dimension::time, "time", "s", {0, 0, 1}},
    {Dimension::area, "area", "m2", {2}},
    {Dimension::volume, "volume", "m3", {3}},
    {Dimension::per_area, "number per square metre", "/m2", {-2}},
    {Dimension::frequency, "frequency", "Hz", {0, 0, -1}},
    {Dimension::mass, "mass", "kg", {0, 0, 0, 1}},
    {Dimension::temperature, "temperature", "K", {0, 0, 0, 0, 1}},
    {Dimension::power, "power", "W", {2, 0, -3, 1}},
    {Dimension::irradiance, "irradiance", "W/m2", {0, 0, -3, 1}},
    {Dimension::luminous_flux, "luminous flux", "lm", {0, 0, 0, 0, 0, 1}},
    {Dimension::luminous_intensity, "luminous intensity", "cd", {0, -2, 0, 0, 0, 1}},
    {Dimension::illuminance, "illuminance", "lx", {-2, 0, 0, 0, 0, 1}},
};

/// Angles per metre are numbers per metre, in radians.
constexpr Powers kAnglePerLength = {-1, 1};

const DimensionRow& row_of(Dimension dimension) { return kRows[static_cast<size_t>(dimension)]; }

std::optional<Dimension> find_dimension(const Powers& powers) {
  for (const DimensionRow& row : kRows)
    if (row.powers == powers) return row.dimension;
  if (powers == kAnglePerLength) return Dimension::per_length;
  return std::nullopt;
}

}  // namespace

std::string to_string(Dimension dimension) { return row_of(dimension).name; }

std::string unit_of(Dimension dimension) { return row_of(dimension).unit; }

bool is_plain(Dimension dimension) { return row_of(dimension).powers == Powers{}; }

std::optional<Dimension> product(Dimension a, Dimension b, int power) {
  const bool both_ratios = a == Dimension::ratio && b == Dimension::ratio;
  if (both_ratios) return power > 0 ? Dimension::ratio : Dimension::none;
  Powers total = row_of(a).powers;
  const Powers& other = row_of(b).powers;
  for (size_t i = 0; i < total.size(); ++i) total[i] += power * other[i];
  return find_dimension(total);
}

std::optional<Dimension> raised(Dimension base, double exponent) {
  Powers total{};
  for (size_t i = 0; i < total.size(); ++i) {
    const double power = row_of(base).powers[i] * exponent;
    if (power != std::floor(power) || std::fabs(power) > 9) return std::nullopt;
    total[i] = static_cast<int>(power);
  }
  return find_dimension(total);
}

}  // namespace vug
