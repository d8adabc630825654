// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/survey_files/therion/settings.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::survey::therion {
namespace {

constexpr double kDegree = kPi / 180;

const std::map<std::string, std::vector<Quantity>>& quantities() {
  static const std::map<std::string, std::vector<Quantity>> all = {
      {"length", {kLength}},
      {"tape", {kLength}},
      {"backlength", {kLength}},
      {"backtape", {kLength}},
      {"compass", {kBearing}},
      {"bearing", {kBearing}},
      {"backcompass", {kBearing}},
      {"backbearing", {kBearing}},
      {"clino", {kGradient}},
      {"gradient", {kGradient}},
      {"backclino", {kGradient}},
      {"backgradient", {kGradient}},
      {"counter", {kCounter}},
      {"count", {kCounter}},
      {"depth", {kDepth}},
      {"depthchange", {kDepth}},
      {"x", {kEasting}},
      {"dx", {kEasting}},
      {"easting", {kEasting}},
      {"y", {kNorthing}},
      {"dy", {kNorthing}},
      {"northing", {kNorthing}},
      {"z", {kAltitude}},
      {"dz", {kAltitude}},
      {"altitude", {kAltitude}},
      {"position", {kPosition}},
      {"left", {kLeft}},
      {"right", {kRight}},
      {"up", {kUp}},
      {"ceiling", {kUp}},
      {"down", {kDown}},
      {"floor", {kDown}},
      {"plumb", {kPlumb}},
      {"level", {kLevel}},
      {"dimensions", {kLeft, kRight, kUp, kDown}},
  };
  return all;
}

}  // namespace

bool is_angle(Quantity quantity) {
  return quantity == kBearing || quantity == kGradient || quantity == kPlumb || quantity == kLevel;
}

bool is_quantity(const std::string& word) { return quantities().count(lower_case(word)) > 0; }

std::vector<Quantity> find_quantities(const Token& word) {
  const auto found = quantities().find(lower_case(word.text));
  if (found == quantities().end())
    fail(fmt::format("unknown quantity {}", quote_text(word.text)), word.where,
         "known: length, compass, clino, counter, depth, x, y, z, position, left, right, up, down, "
         "dimensions, plumb, level");
  return found->second;
}

Unit find_unit(const Token& word, bool angle) {
  static const std::map<std::string, Unit> lengths = {
      {"m", {1}},
      {"meter", {1}},
      {"meters", {1}},
      {"metre", {1}},
      {"metres", {1}},
      {"metric", {1}},
      {"cm", {0.01}},
      {"centimeter", {0.01}},
      {"centimeters", {0.01}},
      {"centimetre", {0.01}},
      {"centimetres", {0.01}},
      {"ft", {0.3048}},
      {"foot", {0.3048}},
      {"feet", {0.3048}},

      {"in", {0.0254}},
      {"inch", {0.0254}},
      {"inches", {0.0254}},
      {"yd", {0.9144}},
      {"yard", {0.9144}},
      {"yards", {0.9144}},
  };
  static const std::map<std::string, Unit> angles = {
      {"deg", {kDegree}},        {"degree", {kDegree}},      {"degrees", {kDegree}},
      {"min", {kDegree / 60}},   {"minute", {kDegree / 60}}, {"minutes", {kDegree / 60}},
      {"grad", {0.9 * kDegree}}, {"grads", {0.9 * kDegree}}, {"mil", {0.9 * kDegree}},
      {"mils", {0.9 * kDegree}}, {"percent", {1, true}},     {"percentage", {1, true}},
  };
  const auto& known = angle ? angles : lengths;
  const auto found = known.find(lower_case(word.text));
  if (found == known.end())
    fail(fmt::format("{} is not a unit of {}", quote_text(word.text), angle ? "angles" : "lengths"),
         word.where,
         angle ? "known: degrees, minutes, grads, percent"
               : "known: metres, centimetres, feet, inches, yards");
  return found->second;
}

double Calibration::operator()(double reading) const {
  const double value = (reading - zero) * scale * factor;
  return unit.percent ? maths::atan2(value, 100) : value * unit.factor;
}

Variances default_variances() {
  const Deviations sd;
  Variances all;
  const auto square = [](double x) { return x * x; };
  all.fill(square(sd.tape));
  all[kBearing] = square(sd.compass);
  all[kGradient] = square(sd.clino);
  all[kCounter] = square(sd.count);
  all[kDepth] = square(sd.depth);
  all[kEasting] = all[kNorthing] = all[kAltitude] = square(sd.coordinate);
  all[kPosition] = square(sd.position);
  all[kPlumb] = square(sd.plumb);
  all[kLevel] = square(sd.level);
  return all;
}

const std::map<std::string, Grade>& known_grades() {
  const auto grade = [](double length, double bearing, double gradient) {
    return Grade{{kLength, length}, {kBearing, bearing * kDegree}, {kGradient, gradient * kDegree}};
  };
  // The values that Therion 6.1 passes to cavern.
  static const std::map<std::string, Grade> all = {
      {"BCRA3", grade(0.25, 1.25, 1.25)},
      {"BCRA5", grade(0.05, 0.5, 0.5)},
      {"UISv1_-1", {}},
      {"UISv1_0", {}},
      {"UISv1_1", {}},
      {"UISv1_2", {}},
      {"UISv1_3", grade(0.25, 2.5, 15)},
      {"UISv1_4", grade(0.05, 1, 1)},
      {"UISv1_5", grade(0.025, 0.5, 0.5)},
      {"UISv1_6", grade(0.01, 0.125, 0.125)},
      {"UISv1_X", {}},
  };
  return all;
}

double read_number(const Token& word) {
  const auto value = parse_number(word.text);
  if (!value || !word.is_word())
    fail(fmt::format("{} is not a number", quote_text(word.text)), word.where,
         "write a decimal number such as 12.5");
  return *value;
}

void read_deviations(const std::vector<Token>& line, size_t at, Grade& grade) {
  std::vector<Quantity> named;
  for (; at < line.size() && is_quantity(line[at].text); ++at)
    for (const Quantity quantity : find_quantities(line[at])) named.push_back(quantity);
  if (named.empty() || line.size() != at + 2)
    fail("a standard deviation has quantities, a number and a unit", line[0].where,
         "write for example: sd length 0.05 metres");
  const double value = read_number(line[at]);
  if (value < 1e-6 || value > 1e6)
    fail("a standard deviation must be between 0.000001 and 1000000", line[at].where,
         "write a positive number");
  for (const Quantity quantity : named)
    grade[quantity] = value * find_unit(line[at + 1], is_angle(quantity)).factor;
}

Settings::Settings() {
  for (size_t i = 0; i < kQuantities; ++i)
    if (is_angle(static_cast<Quantity>(i))) calibrations[i].unit.factor = kDegree;
}

}  // namespace vug::survey::therion
