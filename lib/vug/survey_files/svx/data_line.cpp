// SPDX-License-Identifier: Apache-2.0
// Splits data lines into readings.
#include <vug/survey_files/svx/legs.h>
#include <vug/survey_files/svx/reader.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::survey::svx {
namespace {

using Kind = ItemValue::Kind;

/// A bearing in quadrants in degrees: N30E, S, W.
double read_quadrants(Line& line) {
  line.peek();
  const size_t start = line.position();
  const char* hint = "e.g. N30E, S12.5W or W";
  const auto letter = [&] {
    const char c = static_cast<char>(line.at(0) & ~0x20);
    line.skip(c == 0 ? 0 : 1);
    return c;
  };
  const auto fault = [&] {
    line.set_position(start);
    line.fail_expected("a bearing in quadrants", hint);
  };
  const char first = letter();
  if (first == 'E') return 90;
  if (first == 'W') return 270;
  if (first != 'N' && first != 'S') fault();
  const double base = first == 'N' ? 0 : 180;
  if (line.at(0) == 0 || line.is(line.at(0), kBlank) || line.is(line.at(0), kComment)) return base;
  const std::optional<double> angle = line.try_number();
  const char second = letter();
  if (!angle || *angle < 0 || *angle > 90 || (second != 'E' && second != 'W')) fault();
  const bool clockwise = (first == 'N') == (second == 'E');
  return std::fmod(base + (clockwise ? *angle : 360 - *angle), 360);
}

/// Reads U, D, +V, -V, UP, DOWN, LEVEL or H; the position stays for other texts.
Kind read_clino_word(Line& line) {
  const size_t start = line.position();
  const bool plus = line.is(line.at(0), kPlus), minus = line.is(line.at(0), kMinus);
  if (plus || minus) {
    line.skip(1);
    if (line.keyword() == "v") return plus ? Kind::up : Kind::down;
  } else if (const std::string word = line.keyword(); !word.empty()) {
    if (word == "u" || word == "up") return Kind::up;
    if (word == "d" || word == "down") return Kind::down;
    if (word == "level" || word == "h") return Kind::level;
  }
  line.set_position(start);
  return Kind::absent;
}

ItemValue read_item_value(Line& line, Item item, const Settings& settings) {
  ItemValue value;
  const char first = line.peek();
  value.start = line.position();
  const bool clino = item == Item::clino || item == Item::back_clino;
  if (clino) value.kind = read_clino_word(line);
  if (value.kind != Kind::absent) return value;
  const Quantity quantity = item == Item::compass ? kCompass : kBackCompass;
  const bool compass = item == Item::compass || item == Item::back_compass;
  if (line.is(first, kOmit)) {
    const char next = line.at(1);
    if (next == 0 || line.is(next, kBlank) || line.is(next, kComment)) {
      line.skip(1);
      value.kind = Kind::omitted;
      return value;
    }
  }
  value.kind = Kind::number;
  value.number = compass && settings.calibrations[quantity].unit.scale == Scale::quadrants
                     ? read_quadrants(line)
                     : line.number(clino ? "a gradient, 'up', 'down', 'level' or '-'" : "a number");
  return value;
}

/// The readings of a line: from the item `first` to the one before `last` of the order.
struct LineValues {
  StationName from, to, station;
  bool backwards = false;
  ItemValues values;
};

LineValues read_items(Reader& reader, Line& line, size_t first, size_t last) {
  LineValues out;
  const auto station = [&] {
    return reader.stations.read(line, reader.settings, reader.warnings, true);
  };
  for (size_t i = first; i < last; ++i) {
    const Item item = reader.settings.order->items[i];
    if (item == Item::from) {
      out.from = station();
    } else if (item == Item::to) {
      out.to = station();
    } else if (item == Item::station) {
      out.station = station();
    } else if (item == Item::ignore) {
      if (line.word().empty()) line.fail_expected("a text", "the reading 'ignore' is one word");
    } else if (item == Item::ignore_all) {
      line.rest();
    } else if (item == Item::direction) {
      line.peek();
      const size_t start = line.position();
      const std::string word = line.keyword();
      if (word != "f" && word != "b") {
        line.set_position(start);
        line.fail_expected("'F' or 'B'", "F is forwards, B backwards");
      }
      out.backwards = word == "b";
    } else {
      out.values[item] = read_item_value(line, item, reader.settings);
    }
  }
  line.require_end();
  return out;
}

/// Copies depth and count of the stations to the ends of the leg between them.
void copy_station_values(const ItemValues& station, Item depth, Item count, ItemValues& leg) {
  leg[depth] = station[Item::depth];
  leg[count] = station[Item::count];
}

void read_interleaved(Reader& reader, Line& line, const Order& order) {
  const size_t size = order.items.size();
  size_t newline = 0;
  while (order.items[newline] != Item::newline) ++newline;
  Traverse& traverse = reader.traverse;
  if (traverse.station && !traverse.leg) {
    LineValues read = read_items(reader, line, newline + 1, size);
    traverse.leg = LegLine{traverse.station->station, {}, read.backwards, read.values, line};
    traverse.leg->from.start = 0;
    return;
  }
  LineValues read = read_items(reader, line, 0, newline);
  const StationLine here{read.station, read.values};
  if (traverse.leg) {
    LegLine& leg = *traverse.leg;
    leg.to = here.station;
    copy_station_values(traverse.station->values, Item::from_depth, Item::from_count, leg.values);
    copy_station_values(here.values, Item::to_depth, Item::to_count, leg.values);
    add_leg(reader, leg);
    traverse.leg.reset();
  } else {
    reader.stations.use(here.station.station);
  }
  traverse.station = here;
}

}  // namespace

void read_data_line(Reader& reader, Line& line) {
  const Order& order = *reader.settings.order;
  if (order.style == DataStyle::ignore) return;
  const bool empty = line.peek() == 0;
  if (empty) reader.traverse = {};
  if (line.at_end()) return;
  if (order.interleaved()) return read_interleaved(reader, line, order);
  const LineValues read = read_items(reader, line, 0, order.items.size());
  if (order.style == DataStyle::passage)
    return add_cross_section(reader, read.station, read.values, line);
  add_leg(reader, {read.from, read.to, read.backwards, read.values, line});
}

}  // namespace vug::survey::svx
