// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/byte_reader.h>
#include <vug/survey_files/legs_between.h>
#include <vug/survey_files/lox/chunks.h>
#include <vug/survey_files/lox/write.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace vug::survey::lox {
namespace {

[[noreturn]] void refuse(const std::string& problem, const SourceLocation& where) {
  throw Error(ErrorCode::bad_input, problem, where, "the .lox format cannot store this survey");
}

/// A chunk that is being filled.
struct ChunkWriter {
  std::string records;
  std::string data;
  uint32_t count = 0;

  /// Adds the position and length of a text to the records, and the text to the data.
  void text(const std::string& text) {
    number(static_cast<uint32_t>(data.size()));
    number(static_cast<uint32_t>(text.empty() ? 0 : text.size() + 1));
    if (!text.empty()) data.append(text.c_str(), text.size() + 1);
  }
  template <class T>
  void number(T value) {
    append_bytes(records, value);
  }
  void point(const Vec3d& p, std::string& bytes, const SourceLocation& where) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(p[axis]))
        refuse(fmt::format("the coordinate {} is not finite", p[axis]), where);
      append_bytes(bytes, p[axis]);
    }
  }
  void append_to(std::string& file, Chunk type) const {
    if (std::max(records.size(), data.size()) > std::numeric_limits<uint32_t>::max())
      refuse("a chunk exceeds 4 GiB", {});
    append_bytes(file, static_cast<uint32_t>(type));
    append_bytes(file, static_cast<uint32_t>(records.size()));
    append_bytes(file, count);
    append_bytes(file, static_cast<uint32_t>(data.size()));
    file += records;
    file += data;
  }
};

/// Splits "a.b.c" into "a.b" and "c".
std::pair<std::string, std::string> split(const std::string& name) {
  const size_t point = name.rfind('.');
  if (point == std::string::npos) return {"", name};
  return {name.substr(0, point), name.substr(point + 1)};
}

class Writer {
 public:
  explicit Writer(const Survey& survey) : survey_(survey), leg_at_(survey.stations.size(), -1) {}

  std::string write() {
    add_level("", survey_.title);
    for (size_t i = 0; i < survey_.legs.size(); ++i)
      for (const int end : {survey_.legs[i].from, survey_.legs[i].to})
        leg_at_[static_cast<size_t>(end)] = static_cast<int>(i);
    for (size_t i = 0; i < survey_.stations.size(); ++i) write_station(i);
    write_shots();
    for (const Scrap& scrap : survey_.scraps) write_scrap(scrap);
    std::string file;
    surveys_.append_to(file, kSurveys);
    stations_.append_to(file, kStations);
    shots_.append_to(file, kShots);
    if (scraps_.count > 0) scraps_.append_to(file, kScraps);
    return file;
  }

 private:
  uint32_t add_level(const std::string& path, const std::string& title) {
    const auto [name_of_parent, name] = split(path);
    const uint32_t parent = path.empty() ? 0 : level(name_of_parent);
    const uint32_t id = surveys_.count++;
    surveys_.number(id);
    surveys_.text(name);
    surveys_.number(parent);
    surveys_.text(title);
    levels_.emplace(path, id);
    return id;
  }

  /// The number of a survey, which is added with those around it if it is new.
  uint32_t level(const std::string& path) {
    const auto found = levels_.find(path);
    if (path.size() > kLongestName || std::count(path.begin(), path.end(), '.') >= kDeepestNesting)
      refuse(fmt::format("a name is longer than {} bytes or has more than {} levels", kLongestName,
                         kDeepestNesting),
             {});
    return found != levels_.end() ? found->second : add_level(path, "");
  }

  void write_station(size_t index) {
    const Station& s = survey_.stations[index];
    auto [path, name] = split(s.name);
    if (s.anonymous()) {
      name = s.wall ? kAnonymousWall : kAnonymous;
      if (const int leg = leg_at_[index]; leg >= 0)
        path = survey_.legs[static_cast<size_t>(leg)].survey;
    }
    stations_.number(stations_.count++);
    stations_.number(level(path));
    stations_.text(name);
    stations_.text(s.comment);
    stations_.number((s.surface && !s.underground ? kStationSurface : 0) |
                     (s.entrance ? kStationEntrance : 0) | (s.fixed ? kStationFixed : 0));
    stations_.point(s.position, stations_.records, s.where);
  }

  void write_sides(const CrossSection* section) {
    if (!section) {
      for (int i = 0; i < 4; ++i) shots_.number(-1.0);
      return;
    }
    for (const auto& side : {section->left, section->right, section->up, section->down})
      shots_.number(side.value_or(-1));
  }

  void write_shots() {
    struct Sections {
      const CrossSection* from = nullptr;
      const CrossSection* to = nullptr;
    };
    std::vector<Sections> sections(survey_.legs.size());
    LegsBetween between(survey_.legs);
    for (const Tube& tube : survey_.tubes)
      for (size_t i = 1; i < tube.size(); ++i) {
        const int leg = between.take(tube[i - 1].station, tube[i].station);
        if (leg < 0) continue;
        const bool forward = survey_.legs[static_cast<size_t>(leg)].from == tube[i - 1].station;
        Sections& both = sections[static_cast<size_t>(leg)];
        both = forward ? Sections{&tube[i - 1], &tube[i]} : Sections{&tube[i], &tube[i - 1]};
      }
    for (size_t i = 0; i < survey_.legs.size(); ++i) {
      const Leg& leg = survey_.legs[i];
      shots_.number(static_cast<uint32_t>(leg.from));
      shots_.number(static_cast<uint32_t>(leg.to));
      write_sides(sections[i].from);
      write_sides(sections[i].to);
      shots_.number((leg.surface ? kShotSurface : 0) | (leg.duplicate ? kShotDuplicate : 0) |
                    (leg.splay ? kShotSplay : 0) | (sections[i].from ? 0 : kShotWithoutSection));
      shots_.number(sections[i].from ? kOval : 0);
      shots_.number(level(leg.survey));
      shots_.number(kVerticalThreshold);
      ++shots_.count;
    }
  }

  void write_scrap(const Scrap& scrap) {
    scraps_.number(scraps_.count++);
    scraps_.number(level(scrap.survey));
    std::string points, triangles;
    for (const Vec3d& p : scrap.points) scraps_.point(p, points, {});
    for (const std::array<int, 3>& triangle : scrap.triangles)
      for (const int corner : triangle) append_bytes(triangles, static_cast<uint32_t>(corner));
    for (const auto& [bytes, count] :
         {std::pair(&points, scrap.points.size()), std::pair(&triangles, scrap.triangles.size())}) {
      scraps_.number(static_cast<uint32_t>(count));
      scraps_.number(static_cast<uint32_t>(scraps_.data.size()));
      scraps_.number(static_cast<uint32_t>(bytes->size()));
      scraps_.data += *bytes;
    }
  }

  const Survey& survey_;
  std::vector<int> leg_at_;  ///< The last leg at each station, or -1.
  std::unordered_map<std::string, uint32_t> levels_;
  ChunkWriter surveys_, stations_, shots_, scraps_;
};

}  // namespace

std::string write(const Survey& survey) { return Writer(survey).write(); }

}  // namespace vug::survey::lox
