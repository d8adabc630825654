// SPDX-License-Identifier: Apache-2.0
// The commands that set how data lines are read.
#include <vug/survey_files/svx/commands.h>

#include <vug/survey/dates.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::survey::svx {
namespace {

constexpr double kLargestScale = 1e6;

/// A factor or scale: not 0 and not so large that coordinates overflow.
double read_factor(Line& line, const char* what) {
  line.peek();
  const size_t start = line.position();
  const double factor = line.number(what);
  if (factor == 0 || std::fabs(factor) > kLargestScale || std::fabs(factor) < 1 / kLargestScale)
    line.fail(start, fmt::format("{} is out of range", what), "it is between 1e-6 and 1e6");
  return factor;
}

}  // namespace

void command_calibrate(Reader& reader, Line& line) {
  Settings& settings = reader.settings;
  const std::vector<Quantity> quantities = read_quantities(line);
  if (quantities.empty()) {
    for (Calibration& each : settings.calibrations) each.zero = 0, each.scale = 1;
    settings.declination = {};
    return;
  }
  const double zero = line.number("the zero error");
  line.peek();
  const size_t unit_start = line.position();
  const std::optional<Unit> unit = try_unit(line, quantities.front(), reader.warnings);
  const size_t scale_start = line.position();
  const double scale = line.at_end() ? 1 : read_factor(line, "the scale");
  const size_t end = line.position();
  for (const Quantity quantity : quantities) {
    Calibration& calibration = settings.calibrations[quantity];
    if (unit) {
      line.set_position(unit_start);
      calibration.zero =
          Calibration{*try_unit(line, quantity, reader.warnings)}.converted(zero) / scale;
    } else {
      calibration.zero = calibration.converted(zero);
    }
    calibration.scale = scale;
    if (quantity != kDeclination) continue;
    if (scale != 1) line.fail(scale_start, "the scale of declination is not 1", "remove the scale");
    settings.declination = {};
    settings.declination.value = -calibration.zero;
  }
  line.set_position(end);
}

void command_cartesian(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string north = line.keyword();
  CartesianNorth& setting = reader.settings.cartesian;
  if (north == "grid") {
    setting = CartesianNorth::grid;
  } else if (north == "magnetic") {
    setting = CartesianNorth::magnetic;
  } else if (north == "true") {
    setting = CartesianNorth::geographic;
  } else {
    line.set_position(start);
    line.fail_expected("'grid', 'magnetic' or 'true'", "e.g. *cartesian magnetic");
  }
  line.peek();
  const size_t end = line.position();
  if (line.keyword() == "rotation")
    line.fail(end, "the rotation of '*cartesian' is not supported",
              "turn the data, or write '*cartesian magnetic' with '*declination'");
  line.set_position(end);
}

void command_data(Reader& reader, Line& line) {
  reader.traverse = {};
  reader.in_tube = false;
  if (!line.at_end()) reader.settings.order = read_order(line);
}

void command_date(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string text(line.rest());
  if (text.empty()) line.fail_expected("a date", "e.g. 2024.07.12 or 2024.07.12-2024.07.14");
  const DateText date = parse_dates(text);
  if (!date.fault.empty()) line.fail(start, date.fault, "e.g. 2024.07.12 or 2024.07.12-2024.07.14");
  if (!date.warning.empty())
    reader.warnings.warning(line.range(start), date.warning, "write the year with four digits");
  reader.settings.date = date.range;
}

void command_declination(Reader& reader, Line& line) {
  Settings& settings = reader.settings;
  line.peek();
  const size_t start = line.position();
  if (line.keyword() == "auto") {
    Declination next;
    next.automatic = true;
    next.place.x = line.number("the easting of the place");
    next.place.y = line.number("the northing of the place");
    next.place.z = line.number("the altitude of the place");
    next.coordinate_system = settings.coordinate_system;
    if (next.coordinate_system.empty())
      line.fail(start, "'*declination auto' without '*cs'", "write '*cs' and '*cs out' above it");
    if (reader.out.coordinate_system.empty())
      line.fail(start, "'*declination auto' without '*cs out'", "write '*cs out' above it");
    settings.declination = next;
    return;
  }
  line.set_position(start);
  const double value = line.number("the declination or 'auto'");
  const Unit unit = read_unit(line, kDeclination, reader.warnings);
  settings.declination = {};
  settings.declination.value = value * unit.factor;
}

void command_sd(Reader& reader, Line& line) {
  Settings& settings = reader.settings;
  const std::vector<Quantity> quantities = read_quantities(line);
  if (quantities.empty()) {
    settings.variances = default_variances();
    return;
  }
  line.peek();
  const size_t start = line.position();
  const double value = line.number("the standard deviation");
  const Unit unit = read_unit(line, quantities.front(), reader.warnings);
  const double deviation = value * unit.factor;
  if (!(deviation >= 1e-6 && deviation <= 1e6))
    line.fail(start, "the standard deviation is out of range",
              "it is positive, and between 1e-6 and 1e6 metres or radians");
  for (const Quantity quantity : quantities) settings.variances[quantity] = deviation * deviation;
}

void command_units(Reader& reader, Line& line) {
  Settings& settings = reader.settings;
  const std::vector<Quantity> quantities = read_quantities(line);
  if (quantities.empty()) {
    const auto defaults = default_calibrations();
    for (size_t q = 0; q < kQuantities; ++q) settings.calibrations[q].unit = defaults[q].unit;
    return;
  }
  line.peek();
  const double factor = (line.at(0) >= '0' && line.at(0) <= '9') || line.is(line.at(0), kDecimal)
                            ? read_factor(line, "the factor of the unit")
                            : 1;
  line.peek();
  const size_t start = line.position();
  for (const Quantity quantity : quantities) {
    line.set_position(start);
    Unit unit = read_unit(line, quantity, reader.warnings);
    unit.factor *= factor;
    settings.calibrations[quantity].unit = unit;
  }
}

}  // namespace vug::survey::svx
