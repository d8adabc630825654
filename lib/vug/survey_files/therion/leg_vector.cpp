// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/backsights.h>
#include <vug/survey_files/therion/leg_vector.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::survey::therion {
namespace {

class LegReadings {
 public:
  LegReadings(const DataLine& line, const Settings& settings, Diagnostics& warnings)
      : line_(line), settings_(settings), warnings_(warnings) {}

  double position() const { return settings_.variances[kPosition]; }
  bool has(Item item) const { return line_.values[item].is_number(); }

  /// The calibrated value of a number.
  Reading reading(Item item, Quantity quantity) const {
    return {settings_.calibrations[quantity](line_.values[item].number),
            settings_.variances[quantity]};
  }

  std::optional<Reading> number(Item item, Quantity quantity) const {
    return has(item) ? std::optional(reading(item, quantity)) : std::nullopt;
  }

  Reading length() const {
    const BothDirections read{number(Item::tape, kLength), number(Item::back_tape, kLength)};
    if (const auto direct = read.combine("tape", line_.where, warnings_))
      return checked_length(*direct);
    if (has(Item::from_count) && has(Item::to_count)) {
      // Counters may run in either direction.
      const double from = reading(Item::from_count, kCounter).value;
      const double to = reading(Item::to_count, kCounter).value;
      return {std::fabs(to - from), settings_.variances[kCounter]};
    }
    fail("the length is missing", line_.where, "write the length of the leg");
  }

  Reading checked_length(const Reading& length) const {
    if (length.value < 0)
      fail("the length is negative after calibration", line_.where,
           "check the reading and the calibration");
    return length;
  }

  std::optional<Reading> bearing() const {
    const auto turned = [&](Item item, double turn) -> std::optional<Reading> {
      if (!has(item)) return std::nullopt;
      const double raw = line_.values[item].number;
      const double circle = 2 * kPi / settings_.calibrations[kBearing].unit.factor;
      if (raw < 0 || raw > circle * (1 + 1e-9))
        fail(fmt::format("the bearing {} is not between 0 and {:g}", raw, circle),
             line_.values[item].where, "write the bearing clockwise from north");
      Reading result = reading(item, kBearing);
      result.value = std::remainder(result.value + turn + settings_.declination, 2 * kPi);
      return result;
    };
    return BothDirections{turned(Item::compass, 0), turned(Item::back_compass, kPi)}
        .combine_bearings(line_.where, warnings_);
  }

  std::optional<Reading> gradient() const {
    const auto checked = [&](Item item, double sign) -> std::optional<Reading> {
      if (!has(item)) return std::nullopt;
      Reading result = reading(item, kGradient);
      const double raw = line_.values[item].number;
      const Unit& unit = settings_.calibrations[kGradient].unit;
      if (!unit.percent && std::fabs(raw * unit.factor) > kPi / 2 * (1 + 1e-9))
        fail(fmt::format("the gradient {} is steeper than vertical", raw), line_.values[item].where,
             "write the gradient from the horizontal, or up or down");
      result.value *= sign;
      if (std::fabs(result.value) > kPi / 2 * (1 + 1e-9))
        fail("the calibrated gradient is steeper than vertical", line_.values[item].where,
             "check the calibration");
      return result;
    };
    return BothDirections{checked(Item::clino, 1), checked(Item::back_clino, -1)}.combine(
        "clino", line_.where, warnings_);
  }

  /// 1 for a leg straight up, -1 for one straight down, else 0.
  int plumb() const {
    const Value& fore = line_.values[Item::clino];
    const Value& back = line_.values[Item::back_clino];
    if (fore.is_plumb()) return fore.kind == Value::Kind::up ? 1 : -1;
    if (back.is_plumb() && !fore.is_number()) return back.kind == Value::Kind::up ? -1 : 1;
    return 0;
  }

  Reading rise() const {
    if (has(Item::depth_change)) return reading(Item::depth_change, kDepth);
    if (!has(Item::from_depth) || !has(Item::to_depth))
      fail("the depth is missing", line_.where, "write the depths of both stations");
    const Reading from = reading(Item::from_depth, kDepth);
    const Reading to = reading(Item::to_depth, kDepth);
    return {to.value - from.value, from.variance + to.variance};
  }

  Reading required_bearing() const {
    const auto found = bearing();
    if (!found)
      fail("the bearing is missing", line_.where,
           "only legs whose gradient is up or down may omit the bearing");
    return *found;
  }

 private:
  const DataLine& line_;
  const Settings& settings_;
  Diagnostics& warnings_;
};

MeasuredVector normal_vector(const LegReadings& readings, const Reading& length,
                             const Settings& settings) {
  int plumb = readings.plumb();
  const auto gradient = readings.gradient();
  if (settings.infer_plumbs && gradient && std::fabs(std::fabs(gradient->value) - kPi / 2) < 1e-9)
    plumb = gradient->value > 0 ? 1 : -1;
  if (plumb != 0)
    return plumb_leg({plumb * length.value, length.variance}, settings.variances[kPlumb],
                     readings.position());
  const Reading bearing = readings.required_bearing();
  if (!gradient) return unlevelled_leg(length, bearing, readings.position());
  return polar_leg(length, bearing, *gradient, readings.position());
}

/// Offsets to magnetic north are turned to the north of the grid.
MeasuredVector cartesian_vector(const LegReadings& readings, const Settings& settings) {
  const Reading east = readings.reading(Item::easting, kEasting);
  const Reading north = readings.reading(Item::northing, kNorthing);
  const Reading up = readings.reading(Item::altitude, kAltitude);
  return turned({{east.value, north.value, up.value},
                 {.xx = east.variance, .yy = north.variance, .zz = up.variance}},
                settings.declination);
}

}  // namespace

LegVector leg_vector(const DataLine& line, const Settings& settings, Diagnostics& warnings) {
  const LegReadings readings(line, settings, warnings);
  if (settings.order.style == DataStyle::cartesian) {
    const MeasuredVector measured = cartesian_vector(readings, settings);
    return {measured, measured.vector.length()};
  }
  if (settings.order.style == DataStyle::nosurvey) return {};
  const Reading length = readings.length();
  const double position = readings.position();
  if (settings.order.style == DataStyle::normal)
    return {normal_vector(readings, length, settings), length.value};
  const Reading rise = readings.rise();
  const auto bearing = readings.bearing();
  const bool vertical = !bearing && std::fabs(rise.value) >= length.value;
  const Reading direction = vertical ? Reading{} : readings.required_bearing();
  if (settings.order.style == DataStyle::diving)
    return {diving_leg(length, direction, rise, position), length.value};
  const MeasuredVector measured = cylindrical_leg(length, direction, rise, position);
  return {measured, measured.vector.length()};
}

}  // namespace vug::survey::therion
