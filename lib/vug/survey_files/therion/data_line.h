// SPDX-License-Identifier: Apache-2.0
// The readings of a line of data.
#pragma once

#include <vug/survey_files/therion/settings.h>

namespace vug::survey::therion {

/// A reading as written: a number, "-" or "up" and "down".
struct Value {
  enum class Kind { absent, omitted, number, up, down };
  Kind kind = Kind::absent;
  double number = 0;
  /// The second number of a pair in brackets, e.g. the wall at the end of a leg.
  std::optional<double> second;
  SourceLocation where;

  bool is_number() const { return kind == Kind::number; }
  bool is_plumb() const { return kind == Kind::up || kind == Kind::down; }
};

/// The values of the columns that a line has.
class Values {
 public:
  Value& operator[](Item item) { return values_[static_cast<size_t>(item)]; }
  const Value& operator[](Item item) const { return values_[static_cast<size_t>(item)]; }
  /// Adds the values of another line, e.g. those of a station to those of a leg.
  void add(const Values& other);

 private:
  std::array<Value, kItems> values_;
};

/// A data line or a part of it.
struct DataLine {
  std::optional<Token> from, to, station;
  bool backwards = false;
  Values values;
  SourceLocation where;
};

/// Reads the columns `first` to `end` of the order from the line. Error(bad_input) for missing,
/// superfluous and invalid readings.
DataLine read_data_line(const std::vector<Token>& line, const Order& order, size_t first,
                        size_t end);

}  // namespace vug::survey::therion
