// SPDX-License-Identifier: Apache-2.0
// The readings of a data line, as written.
#pragma once

#include <vug/survey_files/svx/orders.h>
#include <vug/survey_files/svx/stations.h>

#include <array>

namespace vug::survey::svx {

struct ItemValue {
  enum class Kind { absent, omitted, number, up, down, level };
  Kind kind = Kind::absent;
  double number = 0;  ///< In the unit of the file.
  size_t start = 0;   ///< Position on the line.

  bool is_number() const { return kind == Kind::number; }
  bool is_plumb() const { return kind == Kind::up || kind == Kind::down; }
  /// Whether the line has a value, as opposed to "-" or nothing.
  bool given() const { return kind != Kind::absent && kind != Kind::omitted; }
};

/// One value for each Item.
class ItemValues {
 public:
  ItemValue& operator[](Item item) { return values_[static_cast<size_t>(item)]; }
  const ItemValue& operator[](Item item) const { return values_[static_cast<size_t>(item)]; }

 private:
  std::array<ItemValue, kItems> values_;
};

struct StationLine {
  StationName station;
  ItemValues values;  ///< Depth and count.
};

struct LegLine {
  StationName from;
  StationName to;
  bool backwards = false;  ///< By the reading "direction".
  ItemValues values;
  Line line;
};

}  // namespace vug::survey::svx
