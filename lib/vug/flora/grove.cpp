// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/flora/grove.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::flora {
namespace {

constexpr double kMaxDeviations = 2.5;

/// Indices of the points that keep their distance from all earlier kept points.
std::vector<uint64_t> with_spacing(const std::vector<Vec2d>& points, double spacing) {
  std::map<std::pair<int64_t, int64_t>, std::vector<uint64_t>> squares;
  std::vector<uint64_t> kept;
  for (uint64_t i = 0; i < points.size(); ++i) {
    if (!(spacing > 0)) {
      kept.push_back(i);
      continue;
    }
    const auto x = static_cast<int64_t>(std::floor(points[i].x / spacing));
    const auto y = static_cast<int64_t>(std::floor(points[i].y / spacing));
    bool is_free = true;
    for (int64_t column = x - 1; column <= x + 1 && is_free; ++column)
      for (int64_t row = y - 1; row <= y + 1 && is_free; ++row) {
        const auto square = squares.find({column, row});
        if (square == squares.end()) continue;
        is_free = std::none_of(square->second.begin(), square->second.end(), [&](uint64_t other) {
          return (points[other] - points[i]).length2() < spacing * spacing;
        });
      }
    if (!is_free) continue;
    squares[{x, y}].push_back(i);
    kept.push_back(i);
  }
  return kept;
}

/// Whether the vertical line above the point stays `margin` away from the solid.
bool is_clear_of(const field::Field& solid, const GroundPoint& point, double margin,
                 double headroom) {
  const double steepest = std::max(solid.lipschitz(), 1e-6);
  for (double up = 0;;) {
    const double rest = solid.value(point.position + Vec3d(0, up, 0)) - margin;
    if (rest < 0) return false;
    up += std::max(rest / steepest, 0.01);
    if (up > headroom) return true;
  }
}

/// A member of PlacementStats.
using Outcome = size_t PlacementStats::*;

Outcome outcome_on(const GroveOptions& o, const GroundPoint& point, RandomKey key) {
  if (point.normal.y < maths::cos(o.steepest)) return &PlacementStats::too_steep;
  if (point.clearance < o.headroom) return &PlacementStats::no_room;
  for (const field::Field& solid : o.avoid)
    if (!is_clear_of(solid, point, o.margin, o.headroom)) return &PlacementStats::avoided;
  const bool stays = !o.retention || RandomStream(key.at("share")).uniform() < o.retention(point);
  return stays ? &PlacementStats::placed : &PlacementStats::thinned;
}

/// A point that passed the spacing test.
struct Candidate {
  uint64_t number = 0;
  GroundPoint base;
  Outcome outcome = &PlacementStats::no_ground;
};

struct Candidates {
  std::vector<Candidate> all;
  size_t too_near = 0;
};

Candidates candidates(const Plot& plot, const GroveOptions& options, Progress& progress) {
  const DistributionPtr distribution =
      options.distribution ? options.distribution : make_product(distributions(), "uniform");
  const std::vector<Vec2d> points =
      distribution->points(plot, options.density, options.key.at("points"), progress);
  const std::vector<uint64_t> kept = with_spacing(points, options.spacing);
  Candidates out{std::vector<Candidate>(kept.size()), points.size() - kept.size()};
  parallel_for(
      kept.size(),
      [&](size_t i) {
        Candidate& one = out.all[i];
        one.number = kept[i];
        const std::optional<GroundPoint> point = options.ground(points[kept[i]]);
        if (!point) return;
        one.base = *point;
        one.outcome = outcome_on(options, *point, options.key.at(kept[i]));
      },
      64);
  return out;
}

double drawn_diameter(const GroveOptions& o, RandomKey key) {
  RandomStream random(key.at("diameter"));
  for (int tries = 0; tries < 100; ++tries) {
    const double deviation = random.normal(), drawn = o.diameter + deviation * o.diameter_spread;
    if (std::fabs(deviation) <= kMaxDeviations && drawn > 0) return drawn;
  }
  return o.diameter;
}

}  // namespace

PlacementStats placement_stats(const Plot& plot, const GroveOptions& options, Progress& progress) {
  const Candidates made = candidates(plot, options, progress);
  PlacementStats out;
  out.too_near = made.too_near;
  for (const Candidate& one : made.all) ++(out.*one.outcome);
  return out;
}

std::vector<Stem> grove(const Plot& plot, const GroveOptions& options, Progress& progress) {
  std::vector<Stem> stems;
  for (const Candidate& one : candidates(plot, options, progress).all) {
    if (one.outcome != &PlacementStats::placed) continue;
    const RandomKey key = options.key.at(one.number);
    const double diameter = options.diameter > 0 ? drawn_diameter(options, key) : 0;
    stems.push_back({one.base, diameter, key});
  }
  return stems;
}

size_t nearest_diameter(const std::vector<double>& diameters, double wanted, RandomKey key) {
  const auto off = [&](double diameter) { return std::max(diameter / wanted, wanted / diameter); };
  double best = kInfinity;
  for (const double diameter : diameters) best = std::min(best, off(diameter));
  std::vector<size_t> same;
  for (size_t i = 0; i < diameters.size(); ++i)
    if (off(diameters[i]) == best) same.push_back(i);
  return same[RandomStream(key.at("model")).below(static_cast<uint32_t>(same.size()))];
}

}  // namespace vug::flora
