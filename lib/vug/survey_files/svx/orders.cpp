// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/svx/orders.h>

#include <fmt/format.h>
#include <vug/base/diagnostics.h>

#include <algorithm>
#include <map>

namespace vug::survey::svx {
namespace {

constexpr unsigned bit(DataStyle style) { return 1U << static_cast<unsigned>(style); }

constexpr unsigned kNormal = bit(DataStyle::normal), kDiving = bit(DataStyle::diving),
                   kCartesian = bit(DataStyle::cartesian), kCylpolar = bit(DataStyle::cylpolar),
                   kNosurvey = bit(DataStyle::nosurvey), kPassage = bit(DataStyle::passage);
constexpr unsigned kLegs = kNormal | kDiving | kCartesian | kCylpolar | kNosurvey;
constexpr unsigned kMeasured = kNormal | kDiving | kCylpolar;

constexpr const char* kInterleaved = "e.g. *data normal station newline tape compass clino";

/// The styles that have an item.
unsigned styles_of(Item item) {
  switch (item) {
    case Item::from:
    case Item::to:
    case Item::newline:
    case Item::direction:
      return kLegs;
    case Item::station:
    case Item::ignore:
    case Item::ignore_all:
      return kLegs | kPassage;
    case Item::tape:
    case Item::back_tape:
    case Item::compass:
    case Item::back_compass:
    case Item::from_count:
    case Item::to_count:
    case Item::count:
      return kMeasured;
    case Item::clino:
    case Item::back_clino:
      return kNormal | kDiving;
    case Item::from_depth:
    case Item::to_depth:
    case Item::depth:
    case Item::depth_change:
      return kDiving | kCylpolar;
    case Item::easting:
    case Item::northing:
    case Item::altitude:
      return kCartesian;
    case Item::left:
    case Item::right:
    case Item::up:
    case Item::down:
      return kPassage;
  }
  return 0;
}

const std::map<std::string, DataStyle>& style_names() {
  static const std::map<std::string, DataStyle> all = {
      {"cartesian", DataStyle::cartesian}, {"cylpolar", DataStyle::cylpolar},
      {"default", DataStyle::normal},      {"diving", DataStyle::diving},
      {"ignore", DataStyle::ignore},       {"normal", DataStyle::normal},
      {"nosurvey", DataStyle::nosurvey},   {"passage", DataStyle::passage},
      {"topofil", DataStyle::normal}};
  return all;
}

template <class Map>
std::vector<std::string> keys_of(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

/// Adds an item; fails if its place in the order is not possible.
void add_item(Order& order, Item item, const std::string& name, Line& line, size_t start) {
  if (item == Item::newline) {
    const auto of_station = [](Item each) {
      return each == Item::station || each == Item::depth || each == Item::count ||
             each == Item::ignore;
    };
    if (order.interleaved() || !std::all_of(order.items.begin(), order.items.end(), of_station))
      line.fail(start, "'newline' follows the station, its depth and its count, once",
                kInterleaved);
  } else if (item != Item::ignore && order.has(item)) {
    line.fail(start, fmt::format("the reading '{}' is repeated", name),
              "write 'ignore' for a column to skip");
  }
  if (order.interleaved() && (item == Item::from || item == Item::to || item == Item::station))
    line.fail(start, fmt::format("'{}' cannot follow 'newline'", name), kInterleaved);
  if (order.has(Item::ignore_all))
    line.fail(start, "a reading follows 'ignoreall'", "write 'ignoreall' last");
  order.items.push_back(item);
}

/// The name of a reading that the style requires and the order lacks; empty if it is complete.
std::string missing_item(const Order& order) {
  if (order.style == DataStyle::passage) return order.has(Item::station) ? "" : "station";
  if (order.interleaved()) {
    if (!order.has(Item::station)) return "station";
  } else if (!order.has(Item::from) || !order.has(Item::to)) {
    return "'from' and 'to', or 'station newline'";
  }
  if (order.style == DataStyle::nosurvey) return "";
  if (order.style == DataStyle::cartesian) {
    if (!order.has(Item::easting)) return "easting";
    if (!order.has(Item::northing)) return "northing";
    return order.has(Item::altitude) ? "" : "altitude";
  }
  const bool counts = (order.has(Item::from_count) && order.has(Item::to_count)) ||
                      (order.interleaved() && order.has(Item::count));
  if (!order.has(Item::tape) && !order.has(Item::back_tape) && !counts)
    return "tape, backtape, or 'fromcount tocount'";
  if (!order.has(Item::compass) && !order.has(Item::back_compass)) return "compass or backcompass";
  if (order.style == DataStyle::normal) return "";
  const bool depths = (order.has(Item::from_depth) && order.has(Item::to_depth)) ||
                      order.has(Item::depth_change) ||
                      (order.interleaved() && order.has(Item::depth));
  return depths ? "" : "'fromdepth todepth', depthchange, or 'station depth newline'";
}

}  // namespace

bool Order::has(Item item) const {
  return std::find(items.begin(), items.end(), item) != items.end();
}

std::shared_ptr<const Order> default_order() {
  static const auto order = std::make_shared<const Order>(
      Order{DataStyle::normal, {Item::from, Item::to, Item::tape, Item::compass, Item::clino}});
  return order;
}

std::shared_ptr<const Order> read_order(Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string style_name = line.keyword();
  const auto style = style_names().find(style_name);
  if (style == style_names().end()) {
    line.set_position(start);
    line.fail_expected("a data style", suggestion(style_name, keys_of(style_names())));
  }
  if (style_name == "default") return default_order();
  auto order = std::make_shared<Order>(Order{style->second, {}});
  if (order->style == DataStyle::ignore) {
    line.rest();
    return order;
  }
  while (!line.at_end()) {
    const size_t at = line.position();
    const std::string name = line.keyword();
    const auto found = item_names().find(name);
    if (found == item_names().end()) {
      line.set_position(at);
      line.fail_expected("a reading", suggestion(name, keys_of(item_names())));
    }
    if ((styles_of(found->second) & bit(order->style)) == 0)
      line.fail(at, fmt::format("the style '{}' has no reading '{}'", style_name, name),
                "remove it, or write 'ignore' for a column to skip");
    add_item(*order, found->second, name, line, at);
  }
  if (const std::string missing = missing_item(*order); !missing.empty())
    line.fail(start, fmt::format("the style '{}' lacks {}", style_name, missing),
              "e.g. *data normal from to tape compass clino");
  return order;
}

}  // namespace vug::survey::svx
