// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/byte_reader.h>
#include <vug/survey_files/lox/chunks.h>
#include <vug/survey_files/lox/read.h>
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/text_encoding.h>

#include <fmt/format.h>

#include <array>
#include <map>
#include <unordered_map>

namespace vug::survey::lox {
namespace {

/// Distances of a shot's end to the walls; negative if unknown.
using Sides = std::array<double, 4>;

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& file, Diagnostics& warnings)
      : in_(bytes, file), warnings_(warnings), file_bytes_(bytes.size()) {}

  Survey read() {
    if (in_.left() == 0) in_.fail("the file is empty");
    while (in_.left() > 0) read_chunk();
    flag_stations();
    equate_stations();
    return std::move(survey_);
  }

 private:
  void read_chunk() {
    const size_t offset = in_.offset();
    const auto type = in_.number<uint32_t>();
    const auto record_bytes = in_.number<uint32_t>();
    const auto count = in_.number<uint32_t>();
    const auto data_bytes = in_.number<uint32_t>();
    if (type < kSurveys || type > kBitmaps)
      in_.fail_at(offset, fmt::format("unknown chunk {}", type),
                  "expected a .lox file; the file may be damaged");
    constexpr size_t kRecords[] = {0, kSurveyRecord, kStationRecord, kShotRecord, kScrapRecord};
    if (type <= kScraps && record_bytes != kRecords[type] * uint64_t{count})
      in_.fail_at(offset, fmt::format("{} bytes of records do not match {} records of {} bytes",
                                      record_bytes, count, kRecords[type]));
    ByteReader records(in_.text(record_bytes), in_.file(), offset + 16);
    data_offset_ = in_.offset();
    data_ = in_.text(data_bytes);
    if (type > kScraps)
      warnings_.warning({in_.file(), 0, 0},
                        fmt::format("{} of the .lox file were dropped (byte {})",
                                    type == kSurfaces ? "surfaces" : "bitmaps", offset));
    for (uint32_t i = 0; type <= kScraps && i < count; ++i) {
      if (type == kSurveys) read_survey(records);
      if (type == kStations) read_station(records);
      if (type == kShots) read_shot(records);
      if (type == kScraps) read_scrap(records);
    }
  }

  /// The data to which the next two numbers of a record refer.
  ByteReader data(ByteReader& record) {
    const size_t offset = record.offset();
    const auto position = record.number<uint32_t>();
    const auto length = record.number<uint32_t>();
    if (position > data_.size() || length > data_.size() - position)
      record.fail_at(offset, fmt::format("{} bytes at {} exceed the {} bytes of the chunk's data",
                                         length, position, data_.size()));
    return {data_.substr(position, length), in_.file(), data_offset_ + position};
  }

  /// Texts end with a zero byte.
  std::string text(ByteReader& record) {
    const size_t offset = record.offset();
    ByteReader bytes = data(record);
    const std::string_view found = bytes.text(bytes.left());
    if (found.size() > kLongestName)
      record.fail_at(offset, fmt::format("a text is longer than {} bytes", kLongestName));
    return as_utf8(found.substr(0, found.find('\0')));
  }

  void read_survey(ByteReader& record) {
    const size_t offset = record.offset();
    const auto id = record.number<uint32_t>();
    Level level;
    level.name = text(record);
    level.parent = record.number<uint32_t>();
    const std::string title = text(record);
    if (survey_.title.empty()) survey_.title = title;
    if (!levels_.emplace(id, std::move(level)).second)
      record.fail_at(offset, fmt::format("two surveys have the number {}", id));
  }

  /// The names of the surveys from the outermost one, separated by '.'. The outermost survey is its
  /// own parent and mostly has no name.
  const std::string& path(uint32_t id, const ByteReader& record, size_t offset, int depth = 0) {
    const auto found = levels_.find(id);
    if (found == levels_.end()) record.fail_at(offset, fmt::format("survey {} does not exist", id));
    if (depth > kDeepestNesting)
      record.fail_at(offset,
                     fmt::format("surveys are nested more than {} levels deep", kDeepestNesting));
    Level& level = found->second;
    if (level.resolved) return level.path;
    if (level.parent != id) level.path = path(level.parent, record, offset, depth + 1);
    level.path = joined(level.path, level.name, record, offset);
    level.resolved = true;
    return level.path;
  }

  static std::string joined(const std::string& path, const std::string& name,
                            const ByteReader& record, size_t offset) {
    if (path.size() + name.size() + 1 > kLongestName)
      record.fail_at(offset, fmt::format("a full name is longer than {} bytes", kLongestName));
    return path.empty() ? name : path + '.' + name;
  }

  void read_station(ByteReader& record) {
    const size_t offset = record.offset();
    const auto id = record.number<uint32_t>();
    const std::string& survey = path(record.number<uint32_t>(), record, offset);
    const std::string name = text(record);
    Station station;
    station.where.file = in_.file();
    if (name == kAnonymous || name == kAnonymousWall)
      station.wall = name == kAnonymousWall;
    else
      station.name = joined(survey, name, record, offset);
    station.comment = text(record);
    const auto flags = record.number<uint32_t>();
    station.surface = flags & kStationSurface;
    station.entrance = flags & kStationEntrance;
    station.fixed = flags & kStationFixed;
    for (int axis = 0; axis < 3; ++axis) station.position[axis] = read_coordinate<double>(record);
    if (!stations_.emplace(id, static_cast<int>(survey_.stations.size())).second)
      record.fail_at(offset, fmt::format("two stations have the number {}", id));
    survey_.stations.push_back(std::move(station));
  }

  int station(ByteReader& record) const {
    const size_t offset = record.offset();
    const auto id = record.number<uint32_t>();
    const auto found = stations_.find(id);
    if (found == stations_.end())
      record.fail_at(offset, fmt::format("station {} does not exist", id));
    return found->second;
  }

  void read_shot(ByteReader& record) {
    const size_t offset = record.offset();
    Leg leg;
    leg.from = station(record);
    leg.to = station(record);
    Sides from{}, to{};
    require_plausible_leg(survey_.stations[static_cast<size_t>(leg.from)].position,
                          survey_.stations[static_cast<size_t>(leg.to)].position, record, offset);
    for (double& side : from) side = read_wall(record);
    for (double& side : to) side = read_wall(record);
    const auto flags = record.number<uint32_t>();
    leg.surface = flags & kShotSurface;
    leg.duplicate = flags & kShotDuplicate;
    leg.splay = flags & kShotSplay;
    const bool has_section = record.number<uint32_t>() != 0 && !(flags & kShotWithoutSection);
    leg.survey = path(record.number<uint32_t>(), record, offset);
    record.number<double>();  // The angle above which cross-sections are drawn horizontally.
    leg.where.file = in_.file();
    if (has_section) add_sections(leg, from, to);
    survey_.legs.push_back(std::move(leg));
  }

  static CrossSection section(int station, const Sides& sides) {
    const auto known = [](double side) {
      return side < 0 ? std::nullopt : std::optional<double>(side);
    };
    return {station, known(sides[0]), known(sides[1]), known(sides[2]), known(sides[3])};
  }

  /// A shot whose cross-section at `from` is the last one read continues the tube.
  void add_sections(const Leg& leg, const Sides& from, const Sides& to) {
    const bool continues = !survey_.tubes.empty() &&
                           survey_.tubes.back().back().station == leg.from && last_sides_ == from;
    if (!continues) survey_.tubes.push_back({section(leg.from, from)});
    survey_.tubes.back().push_back(section(leg.to, to));
    last_sides_ = to;
  }

  void read_scrap(ByteReader& record) {
    const size_t offset = record.offset();
    record.number<uint32_t>();  // The number of the scrap.
    Scrap scrap;
    scrap.survey = path(record.number<uint32_t>(), record, offset);
    const auto points = record.number<uint32_t>();
    ByteReader coordinates = data(record);
    if (coordinates.left() != 24 * uint64_t{points})
      record.fail_at(offset, fmt::format("{} bytes of coordinates do not match {} points",
                                         coordinates.left(), points));
    const auto triangles = record.number<uint32_t>();
    ByteReader corners = data(record);
    if (corners.left() != 12 * uint64_t{triangles})
      record.fail_at(offset, fmt::format("{} bytes of corners do not match {} triangles",
                                         corners.left(), triangles));
    // Scraps that share their data would need more memory than the file.
    scrap_bytes_ += coordinates.left() + corners.left();
    if (scrap_bytes_ > file_bytes_)
      record.fail_at(offset, "the scraps have more points and triangles than the file");
    scrap.points.resize(points);
    for (Vec3d& p : scrap.points)
      for (int axis = 0; axis < 3; ++axis) p[axis] = read_coordinate<double>(coordinates);
    scrap.triangles.resize(triangles);
    for (std::array<int, 3>& triangle : scrap.triangles)
      for (int& corner : triangle) {
        const auto index = corners.number<uint32_t>();
        if (index >= points)
          corners.fail_at(corners.offset() - 4,
                          fmt::format("a triangle uses point {} of {}", index, points));
        corner = static_cast<int>(index);
      }
    survey_.scraps.push_back(std::move(scrap));
  }

  void flag_stations() {
    for (const Leg& leg : survey_.legs)
      for (const int end : {leg.from, leg.to}) {
        Station& at = survey_.stations[static_cast<size_t>(end)];
        (leg.surface ? at.surface : at.underground) = true;
      }
  }

  void equate_stations() {
    std::map<std::array<double, 3>, int> first;
    for (size_t i = 0; i < survey_.stations.size(); ++i) {
      const Station& s = survey_.stations[i];
      if (s.anonymous()) continue;
      const auto [same, is_new] = first.emplace(
          std::array<double, 3>{s.position.x, s.position.y, s.position.z}, static_cast<int>(i));
      if (!is_new) survey_.equates.push_back({same->second, static_cast<int>(i), s.where});
    }
  }

  struct Level {
    std::string name;
    uint32_t parent = 0;
    std::string path;
    bool resolved = false;
  };

  ByteReader in_;
  Diagnostics& warnings_;
  Survey survey_;
  std::string_view data_;  ///< The data of the current chunk.
  size_t data_offset_ = 0;
  std::unordered_map<uint32_t, Level> levels_;
  std::unordered_map<uint32_t, int> stations_;  ///< Index for each number.
  Sides last_sides_{};                          ///< Those of the last cross-section.
  size_t file_bytes_;
  size_t scrap_bytes_ = 0;
};

}  // namespace

Survey read(std::string_view bytes, const std::string& file, Diagnostics& warnings) {
  return Reader(bytes, file, warnings).read();
}

}  // namespace vug::survey::lox
