// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/byte_reader.h>
#include <vug/survey_files/legs_between.h>
#include <vug/survey_files/survex3d/items.h>
#include <vug/survey_files/survex3d/stations_at.h>
#include <vug/survey_files/survex3d/write.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace vug::survey::survex3d {
namespace {

[[noreturn]] void refuse(const std::string& problem, const SourceLocation& where) {
  throw Error(ErrorCode::bad_input, problem, where, "the .3d format cannot store this survey");
}

/// The value of a station, or of a traverse if `station` is null.
int32_t hundredths(double value, const Station* station) {
  const double scaled = std::round(value / kUnit);
  if (!(std::fabs(scaled) <= std::numeric_limits<int32_t>::max()))
    refuse(fmt::format("the value {:.10g} of {} is not within 21474 km of zero", value,
                       !station               ? std::string("a misclosure")
                       : station->anonymous() ? std::string("an anonymous station")
                                              : "the station '" + station->name + "'"),
           station ? station->where : SourceLocation{});
  return static_cast<int32_t>(scaled);
}

/// The points of all stations in centimetres. Named stations at different places have different
/// points, because readers take those at one point for equated: if two places have the same whole
/// centimetres, the second one is written a centimetre higher.
std::vector<Point> written_points(const std::vector<Station>& stations) {
  constexpr double kSamePlace = 1e-6;  // Metres.
  constexpr int kMostSteps = 100;
  std::vector<Point> points;
  points.reserve(stations.size());
  std::unordered_map<Point, Vec3d, PointHash> places;
  places.reserve(stations.size());
  for (const Station& station : stations) {
    Point p{};
    for (size_t axis = 0; axis < 3; ++axis)
      p[axis] = hundredths(station.position[static_cast<int>(axis)], &station);
    for (int step = 0; !station.anonymous() && step < kMostSteps; ++step) {
      const auto [at, is_free] = places.emplace(p, station.position);
      if (is_free || (at->second - station.position).length() <= kSamePlace) break;
      if (p[2] < std::numeric_limits<int32_t>::max()) ++p[2];
    }
    points.push_back(p);
  }
  return points;
}

/// Text for the line of metadata, in which line feeds and zero bytes separate entries.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\0'; }, ' ');
  return text;
}

class Writer {
 public:
  explicit Writer(const Survey& survey)
      : survey_(survey),
        points_(written_points(survey.stations)),
        written_(survey.legs.size(), false) {}

  std::string write() {
    constexpr size_t kLegBytes = 16, kStationBytes = 32;  // Of most legs and stations.
    out_.reserve(survey_.legs.size() * kLegBytes + survey_.stations.size() * kStationBytes);
    out_ += fmt::format("{}\nv8\n{}", kMagic, one_line(survey_.title));
    if (!survey_.coordinate_system.empty()) (out_ += '\0') += one_line(survey_.coordinate_system);
    out_ += "\n?\n";
    out_ += '\0';  // The flags of the file.
    write_traverses();
    for (size_t i = 0; i < survey_.legs.size(); ++i)
      if (!written_[i]) write_leg(i, survey_.legs[i].from, survey_.legs[i].to);
    // Stations come before cross-sections, because Survex's aven drops those of later stations.
    for (size_t i = 0; i < survey_.stations.size(); ++i) write_station(static_cast<int>(i));
    for (const Tube& tube : survey_.tubes)
      for (const CrossSection& section : tube) write_section(section, &section == &tube.back());
    if (style_ != Style::normal) out_ += '\0';
    out_ += '\0';
    return std::move(out_);
  }

 private:
  const Station& station(int index) const { return survey_.stations[static_cast<size_t>(index)]; }

  void write_point(int index) {
    for (const int32_t axis : points_[static_cast<size_t>(index)]) append_bytes(out_, axis);
  }

  void write_count(size_t count) {
    out_ += static_cast<char>(static_cast<uint8_t>(std::min<size_t>(count, 255)));
    if (count >= 255) append_bytes(out_, static_cast<uint32_t>(count));
  }

  void write_label(const std::string& label, const SourceLocation& where) {
    if (label.size() > kLongestLabel)
      refuse(fmt::format("a name is longer than {} bytes", kLongestLabel), where);
    const size_t limit = std::min(label.size(), label_.size());
    size_t shared = 0;
    while (shared < limit && label[shared] == label_[shared]) ++shared;
    const size_t removed = label_.size() - shared, added = label.size() - shared;
    if (removed < 16 && added < 16 && removed + added > 0) {
      out_ += static_cast<char>(static_cast<uint8_t>(removed << 4 | added));
    } else {
      out_ += '\0';
      write_count(removed);
      write_count(added);
    }
    out_.append(label, shared);
    label_ = label;
  }

  void write_style(Style style) {
    if (style == style_ || style == Style::unknown) return;
    out_ += static_cast<char>(static_cast<int>(style) - static_cast<int>(Style::normal));
    style_ = style;
  }

  void write_date(const std::optional<DateRange>& date, const SourceLocation& where) {
    if (date == date_) return;
    date_ = date;
    if (!date) {
      out_ += static_cast<char>(kNoDate);
      return;
    }
    if (date->first < 0 || date->last > UINT16_MAX || date->last < date->first)
      refuse("a date is not between 1900 and 2079, or a range of dates is reversed", where);
    out_ += static_cast<char>(date->first == date->last ? kDate : kDateRange);
    append_bytes(out_, static_cast<uint16_t>(date->first));
    if (date->first != date->last) append_bytes(out_, static_cast<uint16_t>(date->last));
  }

  void write_leg(size_t index, int from, int to) {
    const Leg& leg = survey_.legs[index];
    written_[index] = true;
    write_style(leg.style);
    write_date(leg.date, leg.where);
    if (from != at_) {
      out_ += static_cast<char>(kMove);
      write_point(from);
    }
    const bool same = leg.survey == label_;
    out_ += static_cast<char>(kLine | (leg.surface ? kLegSurface : 0) |
                              (leg.duplicate ? kLegDuplicate : 0) | (leg.splay ? kLegSplay : 0) |
                              (same ? kSameLabel : 0));
    if (!same) write_label(leg.survey, leg.where);
    write_point(to);
    at_ = to;
  }

  /// The legs of traverses with a misclosure, each traverse in order.
  void write_traverses() {
    if (survey_.misclosures.empty()) return;
    LegsBetween between(survey_.legs);
    for (const Misclosure& misclosure : survey_.misclosures) {
      at_ = -1;  // A traverse begins with a move.
      for (size_t k = 1; k < misclosure.stations.size(); ++k) {
        const int from = misclosure.stations[k - 1], to = misclosure.stations[k];
        const int leg = between.take(from, to);
        if (leg >= 0) write_leg(static_cast<size_t>(leg), from, to);
      }
      if (at_ < 0) continue;
      out_ += static_cast<char>(kError);
      append_bytes(out_, static_cast<int32_t>(misclosure.legs));
      for (const double value : {misclosure.length, misclosure.e, misclosure.h, misclosure.v})
        append_bytes(out_, hundredths(value, nullptr));
    }
    at_ = -1;
  }

  void write_section(const CrossSection& section, bool last) {
    const Station& at = station(section.station);
    int32_t sides[4];
    int32_t largest = 0;
    size_t n = 0;
    for (const auto& side : {section.left, section.right, section.up, section.down}) {
      if (side && *side < 0)
        refuse(fmt::format("a cross-section at '{}' has a negative distance", at.name), at.where);
      sides[n] = side ? hundredths(*side, &at) : -1;
      largest = std::max(largest, sides[n++]);
    }
    const bool wide = largest > INT16_MAX;
    out_ += static_cast<char>((wide ? kWideSection : kSection) | (last ? kLastOfTube : 0));
    write_label(at.name, at.where);
    for (const int32_t side : sides)
      if (wide)
        append_bytes(out_, side);
      else
        append_bytes(out_, static_cast<int16_t>(side));
  }

  void write_station(int index) {
    const Station& s = station(index);
    out_ += static_cast<char>(
        kLabel | (s.surface ? kStationSurface : 0) | (s.underground ? kStationUnderground : 0) |
        (s.entrance ? kStationEntrance : 0) | (s.exported ? kStationExported : 0) |
        (s.fixed ? kStationFixed : 0) | (s.anonymous() ? kStationAnonymous : 0) |
        (s.wall ? kStationWall : 0));
    write_label(s.name, s.where);
    write_point(index);
  }

  const Survey& survey_;
  std::vector<Point> points_;  ///< For each station.
  std::vector<bool> written_;  ///< For each leg.
  std::string out_;
  std::string label_;
  Style style_ = Style::unknown;
  std::optional<DateRange> date_;
  int at_ = -1;  ///< The station of the last point.
};

}  // namespace

std::string write(const Survey& survey) { return Writer(survey).write(); }

}  // namespace vug::survey::survex3d
