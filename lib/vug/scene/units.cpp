// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/units.h>

#include <algorithm>

namespace vug::scene {

namespace {

/// Value in the base unit = written * times / over. Two whole factors make 52% exactly 0.52.
struct Unit {
  const char* name;
  Dimension dimension;
  double times;
  double over;
};

constexpr Unit kUnits[] = {
    {"m", Dimension::length, 1, 1},
    {"cm", Dimension::length, 1, 100},
    {"mm", Dimension::length, 1, 1000},
    {"km", Dimension::length, 1000, 1},
    {"in", Dimension::length, 254, 10000},
    {"ft", Dimension::length, 3048, 10000},
    {"deg", Dimension::angle, kPi, 180},
    {"rad", Dimension::angle, 1, 1},
    {"%", Dimension::ratio, 1, 100},
    {"s", Dimension::time, 1, 1},
    {"ms", Dimension::time, 1, 1000},
    {"m2", Dimension::area, 1, 1},
    {"cm2", Dimension::area, 1, 10000},
    {"mm2", Dimension::area, 1, 1000000},
    {"km2", Dimension::area, 1000000, 1},
    {"m3", Dimension::volume, 1, 1},
    {"cm3", Dimension::volume, 1, 1000000},
    {"mm3", Dimension::volume, 1, 1000000000},
    {"Hz", Dimension::frequency, 1, 1},
    {"kg", Dimension::mass, 1, 1},
    {"K", Dimension::temperature, 1, 1},
    {"W", Dimension::power, 1, 1},
    {"kW", Dimension::power, 1000, 1},
    {"lm", Dimension::luminous_flux, 1, 1},
    {"cd", Dimension::luminous_intensity, 1, 1},
    {"lx", Dimension::illuminance, 1, 1},
};

}  // namespace

std::optional<Number> with_unit(double value, std::string_view unit) {
  for (const Unit& known : kUnits)
    if (unit == known.name) return Number{value * known.times / known.over, known.dimension};
  return std::nullopt;
}

const std::vector<std::string>& unit_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Unit& unit : kUnits)
      if (std::string_view(unit.name) != "%") all.emplace_back(unit.name);
    return all;
  }();
  return names;
}

bool is_unit(std::string_view name) {
  const auto& names = unit_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace vug::scene
