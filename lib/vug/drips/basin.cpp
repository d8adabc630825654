// SPDX-License-Identifier: Apache-2.0
// Columns around the low are visited from low to high (priority flood): the water rises until a
// column is lower than its level.
#include <vug/drips/basin.h>
#include <vug/drips/surface.h>

#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace vug::drips {
namespace {

/// The floor of a neighbouring column is at most this much higher or lower, in metres; otherwise
/// there is a wall or the lip of a shaft.
constexpr double kHighestStep = 0.5, kLowestStep = 1;
/// Differences of height that count as level.
constexpr double kLevelled = 1e-4;

}  // namespace

std::optional<Basin> basin_at(const field::Field& rock, const Vec3d& low, const BasinOptions& o) {
  using Place = std::pair<int, int>;
  const auto at = [&](const Place& p, double y) {
    return Vec3d(low.x + o.cell * p.first, y, low.z + o.cell * p.second);
  };
  // Height, then place: the order does not depend on anything else.
  using Entry = std::tuple<double, Place>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> rim;
  std::map<Place, double> seen{{{0, 0}, low.y}};
  rim.emplace(low.y, Place(0, 0));
  double level = low.y;
  int wet = 0;
  for (int visited = 0; !rim.empty() && visited < o.most; ++visited) {
    const auto [height, place] = rim.top();
    rim.pop();
    if (height < level - kLevelled) {
      if (wet < 2) return std::nullopt;
      return Basin{level, wet * o.cell * o.cell, at(place, height)};
    }
    level = std::max(level, height);
    ++wet;
    for (const Place& step : {Place(1, 0), Place(-1, 0), Place(0, 1), Place(0, -1)}) {
      const Place next(place.first + step.first, place.second + step.second);
      if (seen.contains(next)) continue;
      const Vec3d above = at(next, height + kHighestStep);
      if (!o.region.intersects(at(next, height))) return std::nullopt;
      const VerticalLine line(rock, above, 0.1);
      double floor = kInfinity;
      if (!line.solid(above.y))
        floor = line.crossing(above.y, height - kLowestStep).value_or(height - kLowestStep);
      seen[next] = floor;
      if (floor < kInfinity) rim.emplace(floor, next);
    }
  }
  return std::nullopt;
}

}  // namespace vug::drips
