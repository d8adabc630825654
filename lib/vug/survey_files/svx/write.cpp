// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/svx/write.h>

#include <vug/base/disjoint_sets.h>
#include <vug/base/maths.h>
#include <vug/survey/coordinate_system.h>
#include <vug/survey/dates.h>
#include <vug/survey/geodesy.h>
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/svx/written_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace vug::survey::svx {
namespace {

constexpr size_t kDeepestBlock = 100;  ///< Further levels of names are written at each station.
constexpr double kSamePlace = 0.005;   ///< Metres between stations that are equated.
constexpr int kDays = 65'379;          ///< cavern stores dates from 1900-01-01 to 2078-12-31.

[[noreturn]] void refuse(const std::string& problem, const SourceLocation& where) {
  throw Error(ErrorCode::bad_input, problem, where, "the .svx format cannot store this survey");
}

/// A number without trailing zeros.
std::string decimal(double value, int digits, const SourceLocation& where) {
  if (!(std::fabs(value) <= kLargestCoordinate))
    refuse(fmt::format("the value {} is not within 1e9 metres", value), where);
  std::string text = fmt::format("{:.{}f}", value, digits);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

/// What lines of legs have in common.
struct LegSettings {
  std::optional<DateRange> date;
  bool surface = false;
  bool duplicate = false;
  bool splay = false;
  bool nosurvey = false;
  bool operator==(const LegSettings&) const = default;

  std::string commands() const {
    std::string out;
    if (date) out += fmt::format("*date {}\n", dates());
    if (surface || duplicate || splay)
      out += fmt::format("*flags{}{}{}\n", surface ? " surface" : "", duplicate ? " duplicate" : "",
                         splay ? " splay" : "");
    if (nosurvey) out += "*data nosurvey from to\n";
    return out;
  }

 private:
  std::string dates() const {
    const auto text = [](int day) {
      std::string iso = date_text(day);
      std::replace(iso.begin(), iso.end(), '-', '.');
      return iso;
    };
    return date->first == date->last ? text(date->first)
                                     : text(date->first) + "-" + text(date->last);
  }
};

/// The lines of one survey without those of the surveys in it.
struct Block {
  std::string exports;
  std::string stations;  ///< *fix and *entrance.
  std::vector<const Leg*> list;
  std::string legs;      ///< Their lines.
  std::string rest;      ///< *equate and cross-sections.
  LegSettings settings;  ///< The settings of the last leg.

  void change_settings(const LegSettings& next) {
    if (next == settings) return;
    if (settings != LegSettings{}) legs += "*end\n";
    if (next != LegSettings{}) legs += "*begin\n" + next.commands();
    settings = next;
  }
};

class Writer {
 public:
  explicit Writer(const Survey& survey)
      : survey_(survey), points_(survey.stations.size()), names_(survey, stations_to_name()) {}

  std::string write() {
    for (const Leg& leg : survey_.legs)
      if (leg.from != leg.to)
        blocks_[common(names_.survey(leg.survey), {leg.from, leg.to})].list.push_back(&leg);
    for (auto& [path, block] : blocks_)  // In the order of the text.
      for (const Leg* leg : block.list) add_leg(path, block, *leg);
    for (const Equate& equate : survey_.equates) add_equate(equate);
    add_stations();
    for (const Tube& tube : survey_.tubes) add_tube(tube);
    std::string out = head();
    append_blocks(out);
    return out;
  }

 private:
  const Station& station(int index) const { return survey_.stations[static_cast<size_t>(index)]; }

  /// Anonymous stations that are more than the end of one leg.
  std::vector<bool> stations_to_name() const {
    std::vector<int> uses(survey_.stations.size(), 0);
    const auto use = [&](int index) { uses[static_cast<size_t>(index)] += 2; };
    for (const Leg& leg : survey_.legs) {
      ++uses[static_cast<size_t>(leg.from)];
      ++uses[static_cast<size_t>(leg.to)];
      if (leg.style == Style::nosurvey) use(leg.from), use(leg.to);
      if (station(leg.from).anonymous() && station(leg.to).anonymous()) use(leg.from);
    }
    for (const Equate& equate : survey_.equates) use(equate.a), use(equate.b);
    for (const Tube& tube : survey_.tubes)
      for (const CrossSection& section : tube) use(section.station);
    std::vector<bool> out;
    for (size_t i = 0; i < uses.size(); ++i)
      out.push_back(uses[i] > 1 || survey_.stations[i].fixed || survey_.stations[i].entrance);
    return out;
  }

  /// The longest survey that contains the stations with names, and `within`.
  Path common(Path within, std::initializer_list<int> stations) const {
    within.resize(std::min(within.size(), kDeepestBlock));
    for (const int index : stations) shorten(within, names_.station(index));
    return within;
  }
  static void shorten(Path& within, const Path& name) {
    if (name.empty()) return;
    size_t same = 0;
    while (same < within.size() && same + 1 < name.size() && within[same] == name[same]) ++same;
    within.resize(same);
  }

  /// The survey whose block has the lines of a station that has a name.
  Path block_of(int index) const {
    Path path = names_.station(index);
    path.pop_back();
    path.resize(std::min(path.size(), kDeepestBlock));
    return path;
  }

  std::string name_in(const Path& block, int index) const {
    const Path& name = names_.station(index);
    return fmt::format(
        "{}", fmt::join(name.begin() + static_cast<std::ptrdiff_t>(block.size()), name.end(), "."));
  }

  std::string leg_end(const Path& block, int index, bool splay) const {
    if (!names_.station(index).empty()) return name_in(block, index);
    return !splay ? "..." : station(index).wall ? ".." : ".";
  }

  /// The ends of a leg, turned if the leg of the same stations before it has the other order: a
  /// reader takes repeated lines as measurements of one leg.
  std::pair<int, int> ends_of(const Leg& leg) {
    const std::pair<int, int> ends(leg.from, leg.to), turned(leg.to, leg.from);
    const auto [last, is_new] = last_ends_.emplace(std::minmax(leg.from, leg.to), ends);
    if (!is_new) last->second = last->second == ends ? turned : ends;
    return last->second;
  }

  void add_leg(const Path& path, Block& block, const Leg& leg) {
    const bool anonymous = names_.station(leg.from).empty() || names_.station(leg.to).empty();
    LegSettings settings{leg.date, leg.surface, leg.duplicate, leg.splay && !anonymous,
                         leg.style == Style::nosurvey};
    const bool storable = !leg.date || (leg.date->first >= 0 && leg.date->last < kDays);
    if (!storable) settings.date.reset();
    block.change_settings(settings);
    const auto [from, to] = settings.nosurvey ? std::pair(leg.from, leg.to) : ends_of(leg);
    block.legs += leg_end(path, from, leg.splay) + ' ' + leg_end(path, to, leg.splay);
    if (!settings.nosurvey) {
      points_.join(from, to);
      block.legs += ' ' + readings(from, to, leg.where);
    }
    block.legs += storable ? "\n" : " ; " + date_text(leg.date->first) + "\n";
  }

  /// Tape, compass and clino between the coordinates to a micrometre: the closure of loops
  /// amplifies rounding where long legs, whose bearings have little weight, lie between fixed
  /// stations.
  std::string readings(int from, int to, const SourceLocation& where) const {
    const Vec3d v = station(to).position - station(from).position;
    const double flat = std::hypot(v.x, v.y), length = std::hypot(flat, v.z);
    if (!(length <= kLongestLeg)) refuse("a leg is longer than 10000 km", where);
    const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(length + 1))) + 5, 6, 15);
    const double degrees = 180 / kPi;
    double bearing = maths::atan2(v.x, v.y) * degrees;
    if (bearing < 0) bearing += 360;
    std::string compass = decimal(bearing, digits, where);
    if (compass == "360") compass = "0";
    return fmt::format("{} {} {}", decimal(length, 6, where), compass,
                       decimal(maths::atan2(v.z, flat) * degrees, digits, where));
  }

  void add_equate(const Equate& equate) {
    const Vec3d apart = station(equate.a).position - station(equate.b).position;
    if (!(apart.length() <= kSamePlace) || !equals_.join(equate.a, equate.b)) return;
    points_.join(equate.a, equate.b);
    const Path path = common(block_of(equate.a), {equate.b});
    blocks_[path].rest +=
        fmt::format("*equate {} {}\n", name_in(path, equate.a), name_in(path, equate.b));
  }

  /// Flags, and fixes: at most one for equated stations, at least one for connected ones.
  void add_stations() {
    const size_t n = survey_.stations.size();
    std::vector<bool> fixed(n, false), is_fix(n, false);
    const auto at_root = [&](DisjointSets<int>& sets, size_t i) {
      return static_cast<size_t>(sets.root(static_cast<int>(i)));
    };
    for (size_t i = 0; i < n; ++i) {
      const size_t same = at_root(equals_, i);
      if (!survey_.stations[i].fixed || fixed[same]) continue;
      fixed[same] = is_fix[i] = true;
    }
    std::vector<bool> anchored(n, false);
    for (size_t i = 0; i < n; ++i)
      if (is_fix[i]) anchored[at_root(points_, i)] = true;
    for (size_t i = 0; i < n; ++i) {
      if (names_.station(static_cast<int>(i)).empty() || anchored[at_root(points_, i)]) continue;
      anchored[at_root(points_, i)] = is_fix[i] = true;
    }
    for (size_t i = 0; i < n; ++i) add_station(static_cast<int>(i), is_fix[i]);
  }

  void add_station(int index, bool is_fix) {
    const Station& s = station(index);
    const Path& full = names_.station(index);
    const bool exported = s.exported && full.size() > 1;
    if (full.empty() || !(is_fix || s.entrance || exported)) return;
    const Path path = block_of(index);
    const std::string name = name_in(path, index);
    Block& block = blocks_[path];
    std::string& out = block.stations;
    if (exported) block.exports += fmt::format("*export {}\n", name);
    if (s.entrance) out += fmt::format("*entrance {}\n", name);
    if (!is_fix) return;
    out += fmt::format("*fix {}", name);
    for (int axis = 0; axis < 3; ++axis) out += ' ' + decimal(s.position[axis], 6, s.where);
    out += '\n';
  }

  void add_tube(const Tube& tube) {
    if (tube.empty()) return;
    Path path = block_of(tube.front().station);
    for (const CrossSection& section : tube) shorten(path, names_.station(section.station));
    std::string& out = blocks_[path].rest;
    out += "*begin\n*data passage station left right up down\n";
    for (const CrossSection& section : tube) {
      out += name_in(path, section.station);
      for (const auto& side : {section.left, section.right, section.up, section.down})
        out += ' ' + (side && !(*side < 0) ? decimal(*side, 4, {}) : "-");
      out += '\n';
    }
    out += "*end\n";
  }

  std::string head() const {
    std::string out;
    if (!survey_.title.empty()) {
      std::string title = survey_.title;
      std::replace(title.begin(), title.end(), '"', '\'');
      std::replace_if(
          title.begin(), title.end(),
          [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
      out += fmt::format("*title \"{}\"\n", title);
    }
    out += "*case preserve\n*infer exports on\n";
    if (const std::string unusual = names_.unusual(); !unusual.empty())
      out += fmt::format("*set names _-{}\n", unusual);
    if (const std::string system = coordinate_system_text(); !system.empty())
      out += fmt::format("*cs {}\n*cs out {}\n", system, system);
    return out;
  }

  /// As *cs names it; empty for local metres and for systems that PROJ does not know.
  std::string coordinate_system_text() const {
    const std::string& name = survey_.coordinate_system;
    const auto system = coordinate_system(name);
    if (!system || system->definition.empty() || !Geodesy().fault_of(name).empty()) return "";
    if (!name.starts_with('+')) return name;
    const bool quotable = std::none_of(name.begin(), name.end(), [](char c) {
      return c == '"' || static_cast<unsigned char>(c) < ' ';
    });
    return quotable ? fmt::format("custom \"{}\"", name) : "";
  }

  /// Blocks are in the order of their paths, so that each survey begins once.
  void append_blocks(std::string& out) {
    Path open;
    const auto close_to = [&](size_t levels) {
      for (; open.size() > levels; open.pop_back()) out += fmt::format("*end {}\n", open.back());
    };
    for (auto& [path, block] : blocks_) {
      block.change_settings({});
      const auto differs = std::mismatch(open.begin(), open.end(), path.begin(), path.end());
      close_to(static_cast<size_t>(differs.first - open.begin()));
      while (open.size() < path.size()) {
        open.push_back(path[open.size()]);
        out += fmt::format("*begin {}\n", open.back());
      }
      out += block.exports + block.stations + block.legs + block.rest;
    }
    close_to(0);
  }

  const Survey& survey_;
  DisjointSets<int> points_;  ///< Stations that legs and equates connect.
  DisjointSets<int> equals_{survey_.stations.size()};
  WrittenNames names_;
  std::map<Path, Block> blocks_;
  std::map<std::pair<int, int>, std::pair<int, int>> last_ends_;  ///< For each pair of stations.
};

}  // namespace

std::string write(const Survey& survey) { return Writer(survey).write(); }

}  // namespace vug::survey::svx
