// SPDX-License-Identifier: Apache-2.0
// The stations of a .3d file by their coordinates: legs in such files refer to points.
#pragma once

#include <vug/survey/survey.h>
#include <vug/survey_files/survex3d/items.h>

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace vug::survey::survex3d {

/// East, north and up in centimetres.
using Point = std::array<int32_t, 3>;

inline Vec3d position(const Point& p) { return kUnit * Vec3d(p[0], p[1], p[2]); }

struct PointHash {
  size_t operator()(const Point& p) const {
    uint64_t h = 0;
    for (const int32_t axis : p)
      h = (h ^ static_cast<uint32_t>(axis)) * 0x9e3779b97f4a7c15ull + (h >> 29);
    return static_cast<size_t>(h ^ (h >> 32));
  }
};

class StationsAt {
 public:
  void add(const Point& p, int station) { stations_[p].push_back(station); }

  /// The index of the station at `p` other than `except`; of several stations the first whose name
  /// is in `survey`, else the first. Returns -1 if none is there.
  int find(const Point& p, const std::string& survey, const std::vector<Station>& stations,
           int except = -1) const {
    const auto found = stations_.find(p);
    if (found == stations_.end()) return -1;
    const auto in_survey = [&](const std::string& name) {
      return survey.empty() || (name.size() > survey.size() && name.starts_with(survey) &&
                                name[survey.size()] == '.');
    };
    size_t compared = 0;
    int first = -1;
    for (const int i : found->second) {
      if (i == except) continue;
      if (first < 0) first = i;
      if (in_survey(stations[static_cast<size_t>(i)].name)) return i;
      if (++compared == kMostCompared) break;
    }
    return first;
  }

 private:
  /// Many stations at one point occur only in damaged files, which must not take quadratic time.
  static constexpr size_t kMostCompared = 1000;

  std::unordered_map<Point, std::vector<int>, PointHash> stations_;
};

}  // namespace vug::survey::survex3d
