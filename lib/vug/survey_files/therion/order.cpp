// SPDX-License-Identifier: Apache-2.0
// The columns of data lines and the styles that need them.
#include <vug/survey_files/therion/settings.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey::therion {
namespace {

DataStyle find_style(const Token& word) {
  static const std::map<std::string, DataStyle> all = {
      {"normal", DataStyle::normal},      {"topofil", DataStyle::normal},
      {"diving", DataStyle::diving},      {"cartesian", DataStyle::cartesian},
      {"cylpolar", DataStyle::cylpolar},  {"nosurvey", DataStyle::nosurvey},
      {"dimensions", DataStyle::passage}, {"passage", DataStyle::passage},
  };
  const auto found = all.find(lower_case(word.text));
  if (found == all.end())
    fail(fmt::format("unknown style of data {}", quote_text(word.text)), word.where,
         "known: normal, topofil, diving, cartesian, cylpolar, nosurvey, dimensions");
  return found->second;
}

class Columns {
 public:
  explicit Columns(const std::vector<Item>& items) : items_(items) {}
  bool has(Item item) const {
    return std::find(items_.begin(), items_.end(), item) != items_.end();
  }
  bool any(std::initializer_list<Item> items) const {
    return std::any_of(items.begin(), items.end(), [&](Item item) { return has(item); });
  }

 private:
  const std::vector<Item>& items_;
};

/// The missing columns; empty if the style has all it needs.
std::string missing(DataStyle style, const Columns& columns) {
  if (style == DataStyle::passage) return columns.has(Item::station) ? "" : "station";
  const bool joined = columns.has(Item::station) && columns.has(Item::newline);
  if (!joined && !(columns.has(Item::from) && columns.has(Item::to)))
    return "from and to, or station and newline";
  const bool counts =
      columns.has(Item::count) || (columns.has(Item::from_count) && columns.has(Item::to_count));
  const bool length = counts || columns.any({Item::tape, Item::back_tape});
  const bool bearing = columns.any({Item::compass, Item::back_compass});
  const bool depth = columns.any({Item::depth, Item::depth_change}) ||
                     (columns.has(Item::from_depth) && columns.has(Item::to_depth));
  const bool polar =
      style == DataStyle::normal || style == DataStyle::diving || style == DataStyle::cylpolar;
  if (polar && !length) return "length";
  if (polar && !bearing) return "compass";
  if (style == DataStyle::normal && !columns.any({Item::clino, Item::back_clino})) return "clino";
  if ((style == DataStyle::diving || style == DataStyle::cylpolar) && !depth)
    return "fromdepth and todepth, depth, or depthchange";
  if (style == DataStyle::cartesian &&
      !(columns.has(Item::easting) && columns.has(Item::northing) && columns.has(Item::altitude)))
    return "dx, dy and dz";
  return "";
}

}  // namespace

Order read_order(const std::vector<Token>& line) {
  if (line.size() < 2)
    fail("'data' does not name a style", line[0].where,
         "write for example: data normal from to length compass clino");
  Order order;
  order.style = find_style(line[1]);
  for (size_t i = 2; i < line.size(); ++i) {
    const auto found = item_names().find(lower_case(line[i].text));
    if (found == item_names().end())
      fail(fmt::format("unknown reading {}", quote_text(line[i].text)), line[i].where,
           "readings are e.g. from, to, length, compass, clino, left, right, up, down, ignore");
    const Item item = found->second;
    if (item != Item::ignore &&
        std::find(order.items.begin(), order.items.end(), item) != order.items.end())
      fail(fmt::format("the reading {} is repeated", quote_text(line[i].text)), line[i].where,
           "name each reading once");
    if (item == Item::ignore_all && i + 1 < line.size())
      fail("readings follow 'ignoreall'", line[i].where, "write 'ignoreall' last");
    order.items.push_back(item);
  }
  const Columns columns(order.items);
  if (const std::string lacking = missing(order.style, columns); !lacking.empty())
    fail(fmt::format("the readings of this style lack {}", lacking), line[1].where,
         "add the missing readings");
  if (columns.has(Item::from) != columns.has(Item::to) ||
      (columns.has(Item::from) && columns.has(Item::station)))
    fail("the readings name the stations of a leg twice or incompletely", line[1].where,
         "use either from and to, or station");
  order.interleaved = columns.has(Item::newline);
  return order;
}

}  // namespace vug::survey::therion
