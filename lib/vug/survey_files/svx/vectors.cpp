// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/backsights.h>
#include <vug/survey_files/svx/vectors.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::survey::svx {
namespace {

using Kind = ItemValue::Kind;

constexpr double kRightAngle = kPi / 2;

/// The readings of one leg under the current settings.
struct LegReader {
  Reader& reader;
  const LegLine& leg;

  const Settings& settings() const { return reader.settings; }
  const ItemValue& value(Item item) const { return leg.values[item]; }
  double position() const { return settings().variances[kPosition]; }
  SourceLocation where(Item item) const { return leg.line.word_at(value(item).start); }
  void warn(Item item, const std::string& message, const std::string& hint = {}) const {
    reader.warnings.warning(where(item), message, hint);
  }
  [[noreturn]] void fail(Item item, const std::string& message,
                         const std::string& hint = {}) const {
    throw Error(ErrorCode::bad_input, message, where(item), hint);
  }

  /// The place of a reading costs more than the reading, so it is made only if there are two.
  std::optional<Reading> combined(const BothDirections& read, const char* name, Item back) const {
    if (!read.fore || !read.back) return read.one();
    return read.combine(name, where(back), reader.warnings);
  }

  double calibrated(Item item, Quantity quantity) const {
    return settings().calibrations[quantity](value(item).number);
  }
  Reading reading(Item item, Quantity quantity) const {
    return {calibrated(item, quantity), settings().variances[quantity]};
  }

  Reading tape() const;
  Reading one_tape(Item item, Quantity quantity) const;
  bool has_bearing() const {
    return value(Item::compass).given() || value(Item::back_compass).given();
  }
  /// A leg with a bearing.
  Reading bearing() const;
  Reading one_bearing(Item item, Quantity quantity) const;
  /// A leg with a gradient.
  Reading gradient() const;
  Reading one_gradient(Item item, Quantity quantity) const;
  int plumb() const;
  Reading rise() const;

  MeasuredVector normal(const Reading& length) const;
  MeasuredVector diving(const Reading& length) const;
  MeasuredVector cylindrical(const Reading& length) const;
  MeasuredVector cartesian() const;
};

Reading LegReader::one_tape(Item item, Quantity quantity) const {
  if (value(item).number < 0) warn(item, "the length is negative");
  const Reading read = reading(item, quantity);
  if (value(item).number >= 0 && read.value < 0) warn(item, "the calibrated length is negative");
  return read;
}

Reading LegReader::tape() const {
  BothDirections read;
  if (value(Item::tape).given()) read.fore = one_tape(Item::tape, kTape);
  if (value(Item::back_tape).given()) read.back = one_tape(Item::back_tape, kBackTape);
  if (const auto length = combined(read, "tape", Item::back_tape)) return *length;
  if (value(Item::from_count).is_number() && value(Item::to_count).is_number()) {
    const Calibration& count = settings().calibrations[kCount];
    const double turns = value(Item::to_count).number - value(Item::from_count).number;
    return {count(turns), settings().variances[kCount]};
  }
  const Item named = value(Item::tape).kind == Kind::omitted ? Item::tape : Item::back_tape;
  fail(named, "the leg has no length", "only compass and clino readings may be '-'");
}

Reading LegReader::one_bearing(Item item, Quantity quantity) const {
  const double turned = settings().calibrations[quantity].converted(value(item).number);
  if (turned < 0 || turned > 2 * kPi * (1 + 1e-12))
    warn(item, "the bearing is not between 0 and a full circle");
  return reading(item, quantity);
}

Reading LegReader::bearing() const {
  const double north = reader.north.correction(settings(), reader.out.coordinate_system, leg.line,
                                               leg.from.start, reader.warnings);
  const auto read = [&](Item item, Quantity quantity, double turn) -> std::optional<Reading> {
    if (!value(item).given()) return std::nullopt;
    Reading one = one_bearing(item, quantity);
    one.value += north + turn;
    return one;
  };
  const BothDirections both{read(Item::compass, kCompass, 0),
                            read(Item::back_compass, kBackCompass, kPi)};
  if (const auto one = both.one()) return *one;
  return *both.combine_bearings(where(Item::back_compass), reader.warnings);
}

Reading LegReader::one_gradient(Item item, Quantity quantity) const {
  if (value(item).kind == Kind::level) return {0, settings().variances[kLevel]};
  const double angle = settings().calibrations[quantity].converted(value(item).number);
  if (std::fabs(angle) > kRightAngle * (1 + 1e-12))
    warn(item, "the gradient is steeper than 90 degrees");
  return reading(item, quantity);
}

Reading LegReader::gradient() const {
  BothDirections read;
  if (value(Item::clino).given()) read.fore = one_gradient(Item::clino, kClino);
  if (value(Item::back_clino).given()) {
    read.back = one_gradient(Item::back_clino, kBackClino);
    read.back->value = -read.back->value;
  }
  return *combined(read, "clino", Item::back_clino);
}

/// 1 for a leg vertically up, -1 for one down, 0 for others.
int LegReader::plumb() const {
  const auto direction = [&](Item item) {
    const ItemValue& read = value(item);
    if (read.is_plumb()) return read.kind == Kind::up ? 1 : -1;
    const Quantity quantity = item == Item::clino ? kClino : kBackClino;
    if (!settings().infer_plumbs || !read.is_number()) return 0;
    const double angle = settings().calibrations[quantity].converted(read.number);
    if (std::fabs(std::fabs(angle) - kRightAngle) > 1e-9) return 0;
    return angle > 0 ? 1 : -1;
  };
  const int fore = direction(Item::clino), back = -direction(Item::back_clino);
  if (value(Item::clino).given() && value(Item::back_clino).given() && fore != back)
    fail(Item::back_clino, "the clino readings contradict each other",
         "a leg that is 'up' in one direction is 'down' in the other");
  return fore != 0 ? fore : back;
}

/// The difference in altitude. Depths are altitudes unless a scale of -1 is set by *calibrate.
Reading LegReader::rise() const {
  const double variance = settings().variances[kDepth];
  if (value(Item::depth_change).given())
    return {calibrated(Item::depth_change, kDepth), 2 * variance};
  for (const Item item : {Item::from_depth, Item::to_depth})
    if (!value(item).is_number()) fail(item, "the leg has no depth", "depths may not be '-'");
  return {calibrated(Item::to_depth, kDepth) - calibrated(Item::from_depth, kDepth), 2 * variance};
}

MeasuredVector LegReader::normal(const Reading& length) const {
  if (const int direction = plumb(); direction != 0) {
    if (has_bearing())
      warn(value(Item::compass).given() ? Item::compass : Item::back_compass,
           "a vertical leg has no bearing; its compass reading is ignored", "write '-'");
    return plumb_leg({direction * length.value, length.variance}, settings().variances[kPlumb],
                     position());
  }
  if (!has_bearing()) {
    if (length.value == 0) return plumb_leg(length, 0, position());
    fail(value(Item::compass).kind == Kind::omitted ? Item::compass : Item::back_compass,
         "the compass reading is missing", "only vertical legs ('up', 'down') have none");
  }
  if (!value(Item::clino).given() && !value(Item::back_clino).given())
    return unlevelled_leg(length, bearing(), position());
  return polar_leg(length, bearing(), gradient(), position());
}

MeasuredVector LegReader::diving(const Reading& length) const {
  const Reading height = rise();
  if (!has_bearing()) {
    const Reading signed_length{std::copysign(length.value, height.value), length.variance};
    return plumb_leg(average(height, signed_length).reading, settings().variances[kPlumb],
                     position());
  }
  if (length.value > 0 && length.value < std::fabs(height.value))
    warn(value(Item::tape).given() ? Item::tape : Item::to_depth,
         "the leg is shorter than its difference in depth");
  return diving_leg(length, bearing(), height, position());
}

MeasuredVector LegReader::cylindrical(const Reading& length) const {
  if (!has_bearing() && length.value != 0)
    fail(value(Item::compass).kind == Kind::omitted ? Item::compass : Item::back_compass,
         "the compass reading is missing", "only legs with a horizontal length of 0 have none");
  return cylindrical_leg(length, has_bearing() ? bearing() : Reading{}, rise(), position());
}

MeasuredVector LegReader::cartesian() const {
  const auto axis = [&](Item item, Quantity quantity) {
    if (!value(item).is_number())
      fail(item, "a coordinate is missing", "coordinates may not be '-'");
    return reading(item, quantity);
  };
  const Reading x = axis(Item::easting, kEasting), y = axis(Item::northing, kNorthing),
                z = axis(Item::altitude, kAltitude);
  const MeasuredVector read{{x.value, y.value, z.value},
                            {.xx = x.variance, .yy = y.variance, .zz = z.variance}};
  const double angle = reader.north.cartesian_correction(settings(), reader.out.coordinate_system,
                                                         leg.line, leg.from.start, reader.warnings);
  return angle == 0 ? read : turned(read, angle);
}

}  // namespace

LegVector leg_vector(Reader& reader, const LegLine& line) {
  const LegReader leg{reader, line};
  const DataStyle style = reader.settings.order->style;
  if (style == DataStyle::nosurvey) return {};
  if (style == DataStyle::cartesian) {
    const MeasuredVector measured = leg.cartesian();
    return {measured, measured.vector.length()};
  }
  const Reading length = leg.tape();
  if (style == DataStyle::diving) return {leg.diving(length), length.value};
  if (style == DataStyle::cylpolar) {
    const MeasuredVector measured = leg.cylindrical(length);
    return {measured, measured.vector.length()};
  }
  return {leg.normal(length), length.value};
}

}  // namespace vug::survey::svx
