// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/dates.h>
#include <vug/survey/system_properties.h>
#include <vug/survey_files/therion/centreline.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::survey::therion {
namespace {

constexpr double kLargestConstant = 1e6;  ///< The limit for units and calibrations.

/// Error(bad_input) unless the command has `low` to `high` arguments.
void require_arguments(const std::vector<Token>& line, size_t low, size_t high, const char* form) {
  if (line.size() <= low)
    fail(fmt::format("'{}' lacks an argument", line[0].text), line[0].where,
         fmt::format("write: {}", form));
  if (line.size() > high + 1)
    fail(fmt::format("'{}' has more than {} arguments", line[0].text, high), line[high + 1].where,
         fmt::format("write: {}", form));
}

/// Commands that do not affect stations and legs.
bool is_ignored(const std::string& command) {
  static const std::string_view all[] = {
      "team",  "explo-team", "explo-date", "instrument", "extend",
      "mark",  "walls",      "vthreshold", "title",      "copyright",
      "attr",  "id",         "sketch",     "person",     "calibration-comment",
      "author"};
  return std::find(std::begin(all), std::end(all), command) != std::end(all);
}

}  // namespace

void Centreline::read_line(const std::vector<Token>& line) {
  const std::string command = line[0].is_word() ? lower_case(line[0].text) : "";
  if (is_ignored(command) || read_command(command, line) || read_calibration(command, line)) return;
  if (settings_.order.style == DataStyle::none)
    fail(fmt::format("{} is neither a command nor preceded by 'data'", quote_text(line[0].text)),
         line[0].where, "write for example: data normal from to length compass clino");
  read_data(line);
}

bool Centreline::read_command(const std::string& command, const std::vector<Token>& line) {
  if (command == "data") {
    settings_.order = read_order(line);
    new_tube_ = expects_station_ = true;
    last_.reset();
    leg_.reset();
  } else if (command == "break") {
    new_tube_ = expects_station_ = true;
    last_.reset();
    leg_.reset();
  } else if (command == "group") {
    if (groups_.size() >= 100) fail("groups are nested too deeply", line[0].where, "close groups");
    groups_.emplace_back(settings_, line[0].where);
  } else if (command == "endgroup") {
    if (groups_.empty())
      fail("'endgroup' without 'group'", line[0].where, "remove it, or add 'group' above");
    settings_ = groups_.back().first;
    groups_.pop_back();
  } else if (command == "flags") {
    read_flags(line);
  } else if (command == "date") {
    read_date(line);
  } else if (command == "infer") {
    read_infer(line);
  } else if (command == "station") {
    read_station(line);
  } else if (command == "fix") {
    read_fix(line);
  } else if (command == "cs") {
    read_coordinate_system(line);
  } else if (command == "equate") {
    equate(line, path_, context_);
  } else if (command == "station-names") {
    require_arguments(line, 2, 2, "station-names PREFIX SUFFIX");
    settings_.prefix = line[1].text;
    settings_.suffix = line[2].text;
  } else {
    return false;
  }
  return true;
}

bool Centreline::read_calibration(const std::string& command, const std::vector<Token>& line) {
  if (command == "units") {
    read_units(line);
  } else if (command == "calibrate") {
    read_calibrate(line);
  } else if (command == "declination") {
    read_declination(line);
  } else if (command == "sd") {
    Grade grade;
    read_deviations(line, 1, grade);
    apply(grade);
  } else if (command == "grade") {
    require_arguments(line, 1, line.size(), "grade NAME");
    for (size_t i = 1; i < line.size(); ++i) {
      const auto found = context_.grades.find(line[i].text);
      if (found == context_.grades.end()) {
        std::vector<std::string> known;
        for (const auto& [name, grade] : context_.grades) known.push_back(name);
        fail(fmt::format("unknown grade {}", quote_text(line[i].text)), line[i].where,
             suggestion(line[i].text, known));
      }
      apply(found->second);
    }
  } else {
    return false;
  }
  return true;
}

void Centreline::apply(const Grade& grade) {
  for (const auto& [quantity, deviation] : grade)
    settings_.variances[quantity] = deviation * deviation;
}

void Centreline::read_units(const std::vector<Token>& line) {
  constexpr const char* kForm = "units QUANTITIES [FACTOR] UNIT";
  require_arguments(line, 2, line.size(), kForm);
  size_t end = line.size() - 1;
  const Token& unit = line[end];
  double factor = 1;
  if (end > 2 && !is_quantity(line[end - 1].text)) {
    factor = read_number(line[--end]);
    if (factor <= 0 || factor > kLargestConstant)
      fail("a unit must be positive and at most 1000000", line[end].where,
           "write a number above 0");
  }
  for (size_t i = 1; i < end; ++i)
    for (const Quantity quantity : find_quantities(line[i])) {
      settings_.calibrations[quantity].unit = find_unit(unit, is_angle(quantity));
      settings_.calibrations[quantity].factor = factor;
    }
}

void Centreline::read_calibrate(const std::vector<Token>& line) {
  constexpr const char* kForm = "calibrate QUANTITIES ZERO [SCALE]";
  require_arguments(line, 2, line.size(), kForm);
  size_t end = 1;
  while (end < line.size() && is_quantity(line[end].text)) ++end;
  if (end == 1) find_quantities(line[1]);
  if (end == line.size() || line.size() > end + 2)
    fail("'calibrate' has quantities and one or two numbers", line[0].where,
         fmt::format("write: {}", kForm));
  const double zero = read_number(line[end]);
  const double scale = line.size() > end + 1 ? read_number(line[end + 1]) : 1;
  if (scale == 0) fail("the scale must not be zero", line[end + 1].where, "write a number");
  if (std::fabs(zero) > kLargestConstant || std::fabs(scale) > kLargestConstant)
    fail("a constant of the calibration exceeds 1000000", line[end].where, "check the numbers");
  for (size_t i = 1; i < end; ++i)
    for (const Quantity quantity : find_quantities(line[i])) {
      settings_.calibrations[quantity].zero = zero;
      settings_.calibrations[quantity].scale = scale;
    }
}

void Centreline::read_declination(const std::vector<Token>& line) {
  constexpr const char* kForm = "declination VALUE UNIT";
  require_arguments(line, 1, 2, kForm);
  if (line[1].kind == Token::Kind::bracketed)
    fail("a list of declinations by date is not supported", line[1].where,
         fmt::format("write: {}", kForm));
  require_arguments(line, 2, 2, kForm);
  settings_.declination = read_number(line[1]) * find_unit(line[2], true).factor;
  if (std::fabs(settings_.declination) > 2 * kPi)
    fail("the declination exceeds a whole turn", line[1].where, "check the unit");
}

void Centreline::read_date(const std::vector<Token>& line) {
  require_arguments(line, 1, 3, "date 2024.07.12 or date 2024.07.12 - 2024.07.14");
  std::string text;
  for (size_t i = 1; i < line.size(); ++i) text += line[i].text;
  const DateText date = parse_dates(text);
  if (!date.fault.empty()) fail(date.fault, line[1].where, "write a date such as 2024.07.12");
  if (!date.warning.empty())
    context_.warnings.warning(line[1].where, date.warning, "write the year with four digits");
  settings_.date = date.range;
}

void Centreline::read_flags(const std::vector<Token>& line) {
  require_arguments(line, 1, line.size(), "flags [not] surface|duplicate|splay|approximate");
  bool value = true;
  for (size_t i = 1; i < line.size(); ++i) {
    const std::string flag = lower_case(line[i].text);
    if (flag == "not") {
      value = false;
      continue;
    }
    if (flag == "surface")
      settings_.surface = value;
    else if (flag == "duplicate")
      settings_.duplicate = value;
    else if (flag == "splay")
      settings_.splay = value;
    else if (flag != "approximate" && flag != "approx")
      fail(fmt::format("unknown flag {}", quote_text(line[i].text)), line[i].where,
           "known: surface, duplicate, splay, approximate");
    value = true;
  }
}

void Centreline::read_infer(const std::vector<Token>& line) {
  constexpr const char* kForm = "infer plumbs|equates on|off";
  require_arguments(line, 2, 2, kForm);
  const std::string what = lower_case(line[1].text), state = lower_case(line[2].text);
  if ((what != "plumbs" && what != "equates") || (state != "on" && state != "off"))
    fail("'infer' needs 'plumbs' or 'equates', and 'on' or 'off'", line[1].where,
         fmt::format("write: {}", kForm));
  (what == "plumbs" ? settings_.infer_plumbs : settings_.infer_equates) = state == "on";
}

void Centreline::read_coordinate_system(const std::vector<Token>& line) {
  require_arguments(line, 1, 1, "cs EPSG:32633");
  std::string system = line[1].text;
  const std::string lower = lower_case(system);
  if (lower.starts_with("utm")) {
    const bool south = lower.back() == 's', letter = south || lower.back() == 'n';
    const auto zone =
        parse_integer(std::string_view(lower).substr(3, lower.size() - (letter ? 4 : 3)), 1, 60);
    if (!zone)
      fail(fmt::format("unknown coordinate system {}", quote_text(system)), line[1].where,
           "write for example UTM33, UTM33N or UTM33S");
    system = fmt::format("EPSG:{}", (south ? 32700 : 32600) + *zone);
  } else if (lower.starts_with("epsg:")) {
    system = "EPSG:" + system.substr(5);
  } else if (lower == "local") {
    system.clear();
  } else if (lower == "lat-long" || lower == "long-lat") {
    fail("coordinates in degrees are not supported", line[1].where,
         "convert them to metres, and write e.g. 'cs UTM33'");
  }
  if (const std::string fault = fault_of_survey_system(system); !fault.empty())
    fail(fault, line[1].where, "convert the coordinates to metres, and write e.g. 'cs UTM33'");
  std::string& known = context_.observations.coordinate_system;
  if (!known.empty() && known != system)
    fail(fmt::format("the coordinate system {} differs from {}", quote_text(system),
                     quote_text(known)),
         line[1].where, "use one coordinate system in all files");
  known = system;
}

void Centreline::finish() {
  if (!groups_.empty()) fail("'group' is not closed", groups_.back().second, "add 'endgroup'");
}

}  // namespace vug::survey::therion
