// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/svx/quantities.h>

#include <fmt/format.h>
#include <vug/base/maths.h>
#include <vug/survey/measurement.h>

#include <map>

namespace vug::survey::svx {
namespace {

const std::map<std::string, Quantity>& quantity_names() {
  static const std::map<std::string, Quantity> all = {{"altitude", kAltitude},
                                                      {"backbearing", kBackCompass},
                                                      {"backclino", kBackClino},
                                                      {"backcompass", kBackCompass},
                                                      {"backgradient", kBackClino},
                                                      {"backlength", kBackTape},
                                                      {"backtape", kBackTape},
                                                      {"bearing", kCompass},
                                                      {"ceiling", kUp},
                                                      {"clino", kClino},
                                                      {"compass", kCompass},
                                                      {"count", kCount},
                                                      {"counter", kCount},
                                                      {"declination", kDeclination},
                                                      {"depth", kDepth},
                                                      {"down", kDown},
                                                      {"dx", kEasting},
                                                      {"dy", kNorthing},
                                                      {"dz", kAltitude},
                                                      {"easting", kEasting},
                                                      {"floor", kDown},
                                                      {"gradient", kClino},
                                                      {"left", kLeft},
                                                      {"length", kTape},
                                                      {"level", kLevel},
                                                      {"northing", kNorthing},
                                                      {"plumb", kPlumb},
                                                      {"position", kPosition},
                                                      {"right", kRight},
                                                      {"tape", kTape},
                                                      {"up", kUp},
                                                      {"x", kEasting},
                                                      {"y", kNorthing},
                                                      {"z", kAltitude}};
  return all;
}

constexpr double kDegree = kPi / 180;

const std::map<std::string, Unit>& unit_names() {
  static const Unit metre{}, foot{0.3048}, yard{0.9144}, degree{kDegree, true},
      grad{kPi / 200, true}, minute{kDegree / 60, true}, percent{0.01, true, Scale::percent},
      quadrant{kDegree, true, Scale::quadrants};
  static const std::map<std::string, Unit> all = {
      {"degrees", degree}, {"degs", degree},     {"feet", foot},          {"grads", grad},
      {"meters", metre},   {"metres", metre},    {"metric", metre},       {"mils", grad},
      {"minutes", minute}, {"percent", percent}, {"percentage", percent}, {"quadrants", quadrant},
      {"quads", quadrant}, {"yards", yard}};
  return all;
}

bool is_unit_of(const Unit& unit, Quantity quantity) {
  if (unit.scale == Scale::percent) return quantity == kClino || quantity == kBackClino;
  if (unit.scale == Scale::quadrants) return quantity == kCompass || quantity == kBackCompass;
  return unit.angle == is_angle(quantity);
}

}  // namespace

bool is_angle(Quantity quantity) {
  switch (quantity) {
    case kCompass:
    case kBackCompass:
    case kClino:
    case kBackClino:
    case kDeclination:
    case kLevel:
    case kPlumb:
      return true;
    default:
      return false;
  }
}

std::vector<Quantity> read_quantities(Line& line) {
  std::vector<Quantity> all;
  for (;;) {
    line.peek();
    const size_t start = line.position();
    const std::string name = line.keyword();
    if (name == "default" && all.empty()) return all;
    const auto found = quantity_names().find(name);
    if (found == quantity_names().end()) {
      line.set_position(start);
      if (all.empty()) line.fail_expected("a quantity", "e.g. tape, compass or clino");
      return all;
    }
    all.push_back(found->second);
    if (is_angle(all.back()) != is_angle(all.front()))
      line.fail(start, "angles and lengths cannot be set by one command",
                "write one command for each");
  }
}

std::optional<Unit> try_unit(Line& line, Quantity quantity, Diagnostics& warnings) {
  line.peek();
  const size_t start = line.position();
  const std::string name = line.keyword();
  const auto found = unit_names().find(name);
  if (found == unit_names().end()) {
    line.set_position(start);
    return std::nullopt;
  }
  if (!is_unit_of(found->second, quantity))
    line.fail(start, fmt::format("'{}' is not a unit of this quantity", name),
              is_angle(quantity) ? "angles are in degrees, grads or minutes, gradients also in "
                                   "percent, bearings also in quadrants"
                                 : "lengths are in metres, feet or yards");
  if (name == "mils")
    warnings.warning(line.range(start), "'mils' means grads in Survex, 400 to a circle",
                     "write 'grads'");
  return found->second;
}

Unit read_unit(Line& line, Quantity quantity, Diagnostics& warnings) {
  const std::optional<Unit> unit = try_unit(line, quantity, warnings);
  if (!unit)
    line.fail_expected("a unit",
                       is_angle(quantity) ? "e.g. degrees or grads" : "e.g. metres or feet");
  return *unit;
}

double Calibration::converted(double reading) const {
  if (unit.scale == Scale::percent) return maths::atan2(reading * unit.factor, 1);
  return reading * unit.factor;
}

double Calibration::operator()(double reading) const { return (converted(reading) - zero) * scale; }

std::array<Calibration, kQuantities> default_calibrations() {
  std::array<Calibration, kQuantities> all;
  for (size_t q = 0; q < kQuantities; ++q)
    if (is_angle(static_cast<Quantity>(q))) all[q].unit = {kDegree, true};
  return all;
}

std::array<double, kQuantities> default_variances() {
  const Deviations deviations;
  std::array<double, kQuantities> all;
  for (size_t q = 0; q < kQuantities; ++q) {
    const bool angle = is_angle(static_cast<Quantity>(q));
    const double deviation = q == kLevel   ? deviations.level
                             : q == kPlumb ? deviations.plumb
                             : angle       ? deviations.compass
                                           : deviations.tape;
    all[q] = deviation * deviation;
  }
  return all;
}

}  // namespace vug::survey::svx
