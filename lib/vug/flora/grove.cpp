#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/flora/grove.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::flora {
namespace {

constexpr double kMostDeviations = 2.5;

/// Points that keep their distance from all that come before them, with their numbers.
std::vector<uint64_t> apart(const std::vector<Vec2d>& points, double spacing) {
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

/// Whether the solid stays `margin` away from the line up from the foot.
bool keeps_off(const field::Field& solid, const Foot& foot, double margin, double headroom) {
  const double steepest = std::max(solid.lipschitz(), 1e-6);
  for (double up = 0;;) {
    const double rest = solid.value(foot.position + Vec3d(0, up, 0)) - margin;
    if (rest < 0) return false;
    up += std::max(rest / steepest, 0.01);
    if (up > headroom) return true;
  }
}

/// A member of Fates.
using Fate = size_t Fates::*;

Fate fate_on(const GroveOptions& o, const Foot& foot, RandomKey key) {
  if (foot.normal.y < maths::cos(o.steepest)) return &Fates::too_steep;
  if (foot.room < o.headroom) return &Fates::no_room;
  for (const field::Field& solid : o.avoid)
    if (!keeps_off(solid, foot, o.margin, o.headroom)) return &Fates::avoided;
  const bool stays = !o.share || RandomStream(key.at("share")).uniform() < o.share(foot);
  return stays ? &Fates::stand : &Fates::not_shared;
}

/// A point that is far enough from those before it.
struct Seedling {
  uint64_t number = 0;
  Foot foot;
  Fate fate = &Fates::no_ground;
};

struct Seedlings {
  std::vector<Seedling> all;
  size_t too_near = 0;
};

Seedlings seedlings(const Plot& plot, const GroveOptions& options, Progress& progress) {
  const DistributionPtr distribution =
      options.distribution ? options.distribution : make_product(distributions(), "uniform");
  const std::vector<Vec2d> points =
      distribution->points(plot, options.density, options.key.at("points"), progress);
  const std::vector<uint64_t> kept = apart(points, options.spacing);
  Seedlings out{std::vector<Seedling>(kept.size()), points.size() - kept.size()};
  parallel_for(
      kept.size(),
      [&](size_t i) {
        Seedling& one = out.all[i];
        one.number = kept[i];
        const std::optional<Foot> foot = options.ground(points[kept[i]]);
        if (!foot) return;
        one.foot = *foot;
        one.fate = fate_on(options, *foot, options.key.at(kept[i]));
      },
      64);
  return out;
}

double drawn_diameter(const GroveOptions& o, RandomKey key) {
  RandomStream random(key.at("diameter"));
  for (int tries = 0; tries < 100; ++tries) {
    const double deviation = random.normal(), drawn = o.diameter + deviation * o.diameter_spread;
    if (std::fabs(deviation) <= kMostDeviations && drawn > 0) return drawn;
  }
  return o.diameter;
}

}  // namespace

Fates fates(const Plot& plot, const GroveOptions& options, Progress& progress) {
  const Seedlings made = seedlings(plot, options, progress);
  Fates out;
  out.too_near = made.too_near;
  for (const Seedling& one : made.all) ++(out.*one.fate);
  return out;
}

std::vector<Stem> grove(const Plot& plot, const GroveOptions& options, Progress& progress) {
  std::vector<Stem> stems;
  for (const Seedling& one : seedlings(plot, options, progress).all) {
    if (one.fate != &Fates::stand) continue;
    const RandomKey key = options.key.at(one.number);
    const double diameter = options.diameter > 0 ? drawn_diameter(options, key) : 0;
    stems.push_back({one.foot, diameter, key});
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
