// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/byte_reader.h>
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/survex3d/items.h>
#include <vug/survey_files/survex3d/read.h>
#include <vug/survey_files/survex3d/stations_at.h>
#include <vug/survey_files/text_encoding.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

namespace vug::survey::survex3d {
namespace {

struct RawLeg {
  Leg leg;  ///< Without its stations.
  Point from;
  Point to;
};

struct RawError {
  size_t first_leg = 0;  ///< The traverse: the legs from here to `end_leg`.
  size_t end_leg = 0;
  int legs = 0;
  double length = 0, e = 0, h = 0, v = 0;
};

struct RawSection {
  std::string station;
  size_t offset = 0;
  CrossSection section;
  bool last = false;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& file, Diagnostics& warnings)
      : in_(bytes, file), warnings_(warnings) {}

  Survey read() {
    read_header();
    while (read_item()) {
    }
    if (in_.left() > 0) in_.fail(fmt::format("{} bytes follow the end of the data", in_.left()));
    place_legs();
    place_sections();
    return std::move(survey_);
  }

 private:
  void read_header() {
    if (in_.left() < kMagic.size() || in_.line() != kMagic)
      in_.fail_at(0, "the file does not begin as a Survex .3d file", "expected a .3d file");
    const size_t offset = in_.offset();
    const std::string_view version = in_.line();
    if (version != "v8") {
      const bool plausible =
          version.size() < 9 && version.find('v') <= 1 &&
          std::all_of(version.begin(), version.end(), [](char c) { return c > ' ' && c <= '~'; });
      in_.fail_at(offset,
                  fmt::format("the version of the .3d file is {}, but only v8 is supported",
                              plausible ? version : "not readable"),
                  "process the survey again with cavern of Survex 1.4, or use the .svx file");
    }
    std::string_view metadata = in_.line();
    const auto next_field = [&] {
      const size_t end = std::min(metadata.find('\0'), metadata.size());
      const std::string field(metadata.substr(0, end));
      metadata.remove_prefix(std::min(end + 1, metadata.size()));
      return field;
    };
    survey_.title = as_utf8(next_field());
    survey_.coordinate_system = as_utf8(next_field());
    const std::string separator = next_field();
    if (separator.size() > 1)
      in_.fail_at(offset + version.size() + 1,
                  "the separator of survey levels is not one character");
    if (!separator.empty()) separator_ = separator[0];
    in_.line();  // The time at which the file was written.
    if (in_.number<uint8_t>() & kExtendedElevation)
      warnings_.warning({in_.file(), 0, 0},
                        "the file contains an extended elevation, so its coordinates are not those "
                        "of the cave",
                        "read the .3d file from which 'extend' made it");
  }

  /// Returns false at the end of the data.
  bool read_item() {
    const size_t offset = in_.offset();
    const auto code = in_.number<uint8_t>();
    if (code >= kLabel) {
      read_station(code);
    } else if (code >= kLine) {
      read_leg(code, offset);
    } else if (code >= kSection && code < kSection + 4) {
      read_section(code, offset);
    } else if (code == kStyleNormal && style_ == Style::normal) {
      return false;
    } else if (code <= kStyleNosurvey) {
      constexpr Style kStyles[] = {Style::normal, Style::diving, Style::cartesian, Style::cylpolar,
                                   Style::nosurvey};
      style_ = kStyles[code];
    } else if (code == kMove) {
      at_ = point();
      moved_ = true;
      traverse_ = legs_.size();
    } else if (code == kError) {
      read_error(offset);
    } else {
      read_date(code, offset);
    }
    return true;
  }

  void read_date(uint8_t code, size_t offset) {
    if (code == kNoDate) {
      date_.reset();
      return;
    }
    if (code < kDate || code > kDateRange)
      in_.fail_at(offset, fmt::format("unknown item {:#04x}", code));
    const int first = in_.number<uint16_t>();
    int last = first;
    if (code == kDateShortRange) last += in_.number<uint8_t>() + 1;
    if (code == kDateRange) last = in_.number<uint16_t>();
    if (last < first) in_.fail_at(offset, "a range of dates ends before it begins");
    date_ = DateRange{first, last};
  }

  Point point() {
    Point p{};
    for (int32_t& axis : p) axis = in_.number<int32_t>();
    return p;
  }

  uint32_t label_count() {
    const auto count = in_.number<uint8_t>();
    return count == 255 ? in_.number<uint32_t>() : count;
  }

  /// A label is stored as its difference from the previous one.
  void read_label() {
    const size_t offset = in_.offset();
    const auto counts = in_.number<uint8_t>();
    uint32_t removed = counts >> 4, added = counts & 15;
    if (counts == 0) {
      removed = label_count();
      added = label_count();
    }
    if (removed > label_.size())
      in_.fail_at(offset, fmt::format("a label removes {} of the {} characters of the previous one",
                                      removed, label_.size()));
    label_.resize(label_.size() - removed);
    if (label_.size() + added > kLongestLabel)
      in_.fail_at(offset, fmt::format("a label is longer than {} bytes", kLongestLabel));
    label_ += in_.text(added);
  }

  std::string name() const {
    std::string result = label_;
    if (separator_ != '.') std::replace(result.begin(), result.end(), separator_, '.');
    return as_utf8(result);
  }

  void read_station(uint8_t flags) {
    read_label();
    const Point p = point();
    Station station;
    if (!(flags & kStationAnonymous)) station.name = name();
    station.position = position(p);
    station.surface = flags & kStationSurface;
    station.underground = flags & kStationUnderground;
    station.entrance = flags & kStationEntrance;
    station.exported = flags & kStationExported;
    station.fixed = flags & kStationFixed;
    station.wall = flags & kStationWall;
    station.where.file = in_.file();
    const int index = static_cast<int>(survey_.stations.size());
    if (!station.anonymous())
      if (const auto [same, is_new] = named_.emplace(p, index); !is_new)
        survey_.equates.push_back({same->second, index, station.where});
    stations_.add(p, index);
    survey_.stations.push_back(std::move(station));
  }

  void read_leg(uint8_t flags, size_t offset) {
    if (!moved_) in_.fail_at(offset, "a leg precedes the first position");
    if (!(flags & kSameLabel)) read_label();
    RawLeg raw;
    raw.leg.style = style_;
    raw.leg.surface = flags & kLegSurface;
    raw.leg.duplicate = flags & kLegDuplicate;
    raw.leg.splay = flags & kLegSplay;
    raw.leg.survey = name();
    raw.leg.date = date_;
    raw.leg.where.file = in_.file();
    raw.from = at_;
    raw.to = at_ = point();
    require_plausible_leg(position(raw.from), position(raw.to), in_, offset);
    legs_.push_back(std::move(raw));
  }

  void read_error(size_t offset) {
    RawError error;
    error.first_leg = traverse_;
    error.end_leg = legs_.size();
    error.legs = in_.number<int32_t>();
    for (double* value : {&error.length, &error.e, &error.h, &error.v})
      *value = kUnit * in_.number<int32_t>();
    if (error.legs < 0 || error.length < 0 || error.e < 0 || error.h < 0 || error.v < 0)
      in_.fail_at(offset, "the error of a traverse is negative");
    errors_.push_back(error);
  }

  template <class T>
  std::optional<double> distance() {
    const size_t offset = in_.offset();
    const auto value = in_.number<T>();
    if (value < 0) return std::nullopt;
    if (!is_plausible_wall(kUnit * value)) in_.fail_at(offset, kImplausibleWall);
    return kUnit * value;
  }

  void read_section(uint8_t code, size_t offset) {
    read_label();
    RawSection raw;
    raw.station = name();
    raw.offset = offset;
    raw.last = code & kLastOfTube;
    for (std::optional<double>* side :
         {&raw.section.left, &raw.section.right, &raw.section.up, &raw.section.down})
      *side = code >= kWideSection ? distance<int32_t>() : distance<int16_t>();
    sections_.push_back(std::move(raw));
  }

  int station_at(const Point& p, const std::string& survey) {
    const int found = stations_.find(p, survey, survey_.stations);
    if (found >= 0) return found;
    const int added = static_cast<int>(survey_.stations.size());
    Station station;
    station.position = position(p);
    station.where.file = in_.file();
    survey_.stations.push_back(std::move(station));
    stations_.add(p, added);
    return added;
  }

  /// A leg shorter than a centimetre joins two stations at one point, which are then not equated:
  /// the leg and the equate would be a loop.
  void place_short_leg(Leg& leg, const Point& p) {
    const int other = stations_.find(p, leg.survey, survey_.stations, leg.from);
    if (other < 0) return;
    leg.to = other;
    short_.insert(std::minmax({leg.from, leg.to}));
  }

  void place_legs() {
    for (RawLeg& raw : legs_) {
      raw.leg.from = station_at(raw.from, raw.leg.survey);
      raw.leg.to = station_at(raw.to, raw.leg.survey);
      if (raw.from == raw.to) place_short_leg(raw.leg, raw.to);
      survey_.legs.push_back(std::move(raw.leg));
    }
    std::erase_if(survey_.equates, [&](const Equate& each) {
      return short_.count(std::minmax({each.a, each.b})) > 0;
    });
    for (const RawError& raw : errors_) {
      Misclosure misclosure;
      misclosure.legs = raw.legs;
      misclosure.length = raw.length;
      misclosure.e = raw.e;
      misclosure.h = raw.h;
      misclosure.v = raw.v;
      for (size_t i = raw.first_leg; i < raw.end_leg; ++i) {
        if (i == raw.first_leg) misclosure.stations.push_back(survey_.legs[i].from);
        misclosure.stations.push_back(survey_.legs[i].to);
      }
      survey_.misclosures.push_back(std::move(misclosure));
    }
  }

  void place_sections() {
    std::unordered_map<std::string, int> index;
    for (size_t i = 0; i < survey_.stations.size(); ++i)
      if (!survey_.stations[i].anonymous())
        index.emplace(survey_.stations[i].name, static_cast<int>(i));
    bool open = false;
    for (const RawSection& raw : sections_) {
      const auto found = index.find(raw.station);
      if (found == index.end()) {
        warnings_.warning({in_.file(), 0, 0},
                          fmt::format("the cross-section of the unknown station '{}' was dropped "
                                      "(byte {})",
                                      raw.station, raw.offset),
                          "the file may be damaged; make it again from the .svx file");
      } else {
        if (!open) survey_.tubes.emplace_back();
        open = true;
        survey_.tubes.back().push_back(raw.section);
        survey_.tubes.back().back().station = found->second;
      }
      if (raw.last) open = false;
    }
  }

  ByteReader in_;
  Diagnostics& warnings_;
  Survey survey_;
  char separator_ = '.';
  std::string label_;
  Style style_ = Style::unknown;
  std::optional<DateRange> date_;
  Point at_{};
  bool moved_ = false;
  size_t traverse_ = 0;  ///< The first leg since the last move.
  std::vector<RawLeg> legs_;
  std::vector<RawError> errors_;
  std::set<std::pair<int, int>> short_;  ///< Stations that a short leg joins.
  std::vector<RawSection> sections_;
  StationsAt stations_;
  std::unordered_map<Point, int, PointHash> named_;  ///< The first station with a name.
};

}  // namespace

Survey read(std::string_view bytes, const std::string& file, Diagnostics& warnings) {
  return Reader(bytes, file, warnings).read();
}

}  // namespace vug::survey::survex3d
