// SPDX-License-Identifier: Apache-2.0
// Data styles and the order of readings on data lines, as *data sets them.
#pragma once

#include <vug/survey/svx/line.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace vug::survey::svx {

enum class DataStyle { normal, diving, cartesian, cylpolar, nosurvey, passage, ignore };

enum class Item : uint8_t {
  from,
  to,
  station,
  newline,
  direction,
  tape,
  back_tape,
  compass,
  back_compass,
  clino,
  back_clino,
  from_count,
  to_count,
  count,
  from_depth,
  to_depth,
  depth,
  depth_change,
  easting,
  northing,
  altitude,
  left,
  right,
  up,
  down,
  ignore,
  ignore_all,
};
inline constexpr size_t kItems = static_cast<size_t>(Item::ignore_all) + 1;

struct Order {
  DataStyle style = DataStyle::normal;
  std::vector<Item> items;

  bool has(Item item) const;
  /// Whether stations and legs alternate on their own lines.
  bool interleaved() const { return has(Item::newline); }
};

/// From, to, tape, compass, clino.
std::shared_ptr<const Order> default_order();
/// Reads the style and the items of *data.
std::shared_ptr<const Order> read_order(Line& line);

}  // namespace vug::survey::svx
