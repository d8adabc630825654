// SPDX-License-Identifier: Apache-2.0
// Data styles and the order of readings on data lines, as *data sets them.
#pragma once

#include <vug/survey_files/data_items.h>
#include <vug/survey_files/svx/line.h>

#include <memory>
#include <vector>

namespace vug::survey::svx {

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
