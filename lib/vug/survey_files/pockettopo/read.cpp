// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/byte_reader.h>
#include <vug/survey_files/named_stations.h>
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/pockettopo/read.h>
#include <vug/survey_files/pockettopo/shots.h>
#include <vug/survey_files/text_encoding.h>

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace vug::survey::pockettopo {
namespace {

constexpr int32_t kUndefined = INT32_MIN;
constexpr uint8_t kHasComment = 2;
constexpr double kMillimetre = 0.001;
constexpr double kAngleUnit = 2 * kPi / 65536;

// Elements of a drawing.
constexpr uint8_t kEndOfDrawing = 0;
constexpr uint8_t kPolygon = 1;
constexpr uint8_t kCrossSection = 3;

/// Days since 1900-01-01 of a time in units of 100 ns since the year 1; nothing before 1900 and
/// after 2199.
std::optional<DateRange> date_of(int64_t ticks) {
  constexpr int64_t kTicksPerDay = 864'000'000'000;
  constexpr int64_t kFirst = 693'595;  // 1900-01-01
  constexpr int64_t kDays = 109'573;   // 1900-01-01 to 2200-01-01
  const int64_t days = ticks / kTicksPerDay - kFirst;
  if (days < 0 || days >= kDays) return std::nullopt;
  return DateRange{static_cast<int>(days), static_cast<int>(days)};
}

struct Trip {
  std::optional<DateRange> date;
  double declination = 0;
};

/// A leg whose shots are being averaged.
struct OpenLeg {
  int32_t from = 0, to = 0, trip = 0;
  RepeatedShot shots;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& file, Diagnostics& warnings)
      : in_(bytes, file), warnings_(warnings), stations_(result_.stations), where_{file, 0, 0} {}

  Observations read() {
    if (in_.left() < 4 || in_.text(3) != "Top")
      in_.fail_at(0, "the file does not begin as a PocketTopo file", "expected a .top file");
    if (const int version = in_.number<uint8_t>(); version != 3)
      in_.fail_at(
          3, fmt::format("the version of the .top file is {}, but only 3 is supported", version),
          "save the file with PocketTopo 1.3 or newer");
    for (uint32_t n = count(12); n > 0; --n) read_trip();
    const uint32_t shots = count(22);
    for (shot_ = 1; shot_ <= shots; ++shot_) read_shot();
    close_leg();
    for (uint32_t n = count(25); n > 0; --n) read_reference();
    skip_mapping();
    skip_drawing();
    skip_drawing();
    return std::move(result_);
  }

 private:
  /// The number of the entries that follow, each of at least `bytes`.
  uint32_t count(size_t bytes) {
    const size_t offset = in_.offset();
    const auto n = in_.number<uint32_t>();
    if (n > in_.left() / bytes)
      in_.fail_at(offset, fmt::format("the file is too short for {} entries", n));
    return n;
  }

  std::string text() {
    const size_t offset = in_.offset();
    uint64_t length = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = in_.number<uint8_t>();
      length |= static_cast<uint64_t>(byte & 0x7f) << shift;
      if (!(byte & 0x80)) break;
      if (shift == 28) in_.fail_at(offset, "the length of a text has more than 5 bytes");
    }
    return as_utf8(in_.text(length));
  }

  std::string name(int32_t id) const {
    if (id < 0) return std::to_string(id - (kUndefined + 1));
    return fmt::format("{}.{}", id >> 16, id & 0xffff);
  }
  static std::string series(int32_t id) { return id < 0 ? "" : std::to_string(id >> 16); }
  int station(int32_t id) { return stations_.find_or_add(name(id), where_); }

  void read_trip() {
    const size_t offset = in_.offset();
    Trip trip;
    trip.date = date_of(in_.number<int64_t>());
    if (!trip.date)
      warnings_.warning(where_,
                        fmt::format("the date of a trip is not between 1900 and 2199 and "
                                    "was dropped (byte {})",
                                    offset),
                        "set the date of the trip in PocketTopo");
    const std::string comment = text();
    if (result_.title.empty()) result_.title = comment.substr(0, comment.find_first_of("\r\n"));
    trip.declination = kAngleUnit * in_.number<int16_t>();
    trips_.push_back(trip);
  }

  void read_shot() {
    const size_t offset = in_.offset();
    const auto from = in_.number<int32_t>();
    const auto to = in_.number<int32_t>();
    const auto length = in_.number<int32_t>();
    Shot shot;
    shot.length = kMillimetre * length;
    shot.bearing = kAngleUnit * in_.number<uint16_t>();
    shot.gradient = kAngleUnit * in_.number<int16_t>();
    const auto flags = in_.number<uint8_t>();
    in_.number<uint8_t>();  // The roll of the instrument.
    const int32_t trip = in_.number<int16_t>();
    if (flags & kHasComment) text();
    if (length < 0)
      in_.fail_at(offset, fmt::format("the length of shot {} is negative: {} mm", shot_, length));
    if (trip < -1 || trip >= static_cast<int32_t>(trips_.size()))
      in_.fail_at(offset,
                  fmt::format("shot {} belongs to trip {} of {}", shot_, trip, trips_.size()));
    if (trip >= 0) shot.bearing += trips_[static_cast<size_t>(trip)].declination;
    add_shot(from, to, trip, shot);
  }

  void add_shot(int32_t from, int32_t to, int32_t trip, const Shot& shot) {
    if (from == kUndefined && to == kUndefined) {
      warnings_.warning(where_, fmt::format("shot {} has no stations and was dropped", shot_),
                        "name its stations in PocketTopo");
    } else if (from == kUndefined || to == kUndefined) {
      close_leg();
      const bool outward = to == kUndefined;
      if (shot.length > 0) add_splay(outward ? from : to, trip, outward ? shot : shot.reversed());
    } else if (from == to) {
      warnings_.warning(
          where_, fmt::format("shot {} leads from {} to itself and was dropped", shot_, name(from)),
          "correct one of its stations in PocketTopo");
    } else if (shot.length == 0) {
      close_leg();
      result_.add(Equate{station(from), station(to), where_});
    } else {
      add_leg_shot(from, to, trip, shot);
    }
  }

  void add_leg_shot(int32_t from, int32_t to, int32_t trip, const Shot& shot) {
    const bool same = open_ && open_->from == from && open_->to == to;
    const bool back = open_ && open_->from == to && open_->to == from;
    const Shot forward = back ? shot.reversed() : shot;
    if ((same || back) && open_->shots.agrees(forward)) {
      open_->shots.add(forward);
      return;
    }
    if (same || back)
      warnings_.warning(where_,
                        fmt::format("shot {} from {} to {} differs from the previous one by more "
                                    "than 5 cm or 1.7 degrees and became a leg of its own",
                                    shot_, name(from), name(to)),
                        "delete the wrong shot in PocketTopo");
    close_leg();
    open_ = OpenLeg{from, to, trip, RepeatedShot(shot)};
  }

  void close_leg() {
    if (!open_) return;
    add_leg(station(open_->from), station(open_->to), series(open_->from), open_->trip,
            open_->shots);
    open_.reset();
  }

  void add_splay(int32_t from, int32_t trip, const Shot& shot) {
    const int start = station(from);
    add_leg(start, stations_.add_anonymous(true, where_), series(from), trip, RepeatedShot(shot));
    result_.legs.back().leg.splay = true;
  }

  void add_leg(int from, int to, const std::string& survey, int32_t trip,
               const RepeatedShot& shots) {
    const MeasuredVector measured = shots.measured({});
    ObservedLeg leg;
    leg.leg.from = from;
    leg.leg.to = to;
    leg.leg.style = Style::normal;
    leg.leg.survey = survey;
    leg.leg.length = shots.mean().length;
    if (trip >= 0) leg.leg.date = trips_[static_cast<size_t>(trip)].date;
    leg.leg.where = where_;
    leg.vector = measured.vector;
    leg.covariance = measured.covariance;
    result_.legs.push_back(std::move(leg));
  }

  void read_reference() {
    const size_t offset = in_.offset();
    const auto id = in_.number<int32_t>();
    Fix fix;
    fix.position.x = read_coordinate<int64_t>(in_, kMillimetre);
    fix.position.y = read_coordinate<int64_t>(in_, kMillimetre);
    fix.position.z = read_coordinate<int32_t>(in_, kMillimetre);
    const std::string comment = text();
    if (id == kUndefined) in_.fail_at(offset, "a reference does not name a station");
    fix.station = station(id);
    fix.where = where_;
    Station& fixed = result_.stations[static_cast<size_t>(fix.station)];
    fixed.fixed = true;
    fixed.comment = comment;
    result_.add(fix);
  }

  void skip_mapping() { in_.text(12); }

  void skip_drawing() {
    skip_mapping();
    for (;;) {
      const size_t offset = in_.offset();
      const auto element = in_.number<uint8_t>();
      if (element == kEndOfDrawing) return;
      if (element == kPolygon) {
        in_.text(8 * uint64_t{count(8)});
        in_.text(1);  // The colour.
      } else if (element == kCrossSection) {
        in_.text(16);
      } else {
        in_.fail_at(offset, fmt::format("unknown element {} of a drawing", element));
      }
    }
  }

  ByteReader in_;
  Diagnostics& warnings_;
  Observations result_;
  NamedStations stations_;
  SourceLocation where_;
  std::vector<Trip> trips_;
  uint32_t shot_ = 0;  ///< The number of the current shot, from 1.
  std::optional<OpenLeg> open_;
};

}  // namespace

Observations read(std::string_view bytes, const std::string& file, Diagnostics& warnings) {
  return Reader(bytes, file, warnings).read();
}

}  // namespace vug::survey::pockettopo
