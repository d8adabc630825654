// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/karst/key_points.h>

#include <cmath>

namespace vug::karst {
namespace {

constexpr int kTries = 200;  ///< Attempts at a random point in the rock.
constexpr int kCandidates =
    6;  ///< Random points from which the one farthest from all others is taken.
constexpr double kMargin = 0.06;  ///< Distance of random points from the sides, in their length.

class RandomPoints {
 public:
  RandomPoints(const Rock& rock, RandomKey key) : rock_(rock), random_(key) {}

  /// A point in the plan of the bounds, away from their sides.
  Vec3d in_plan() {
    const Box3d& box = rock_.geology().bounds;
    const Vec3d size = box.size();
    const double x = random_.uniform(kMargin, 1 - kMargin);
    const double z = random_.uniform(kMargin, 1 - kMargin);
    return {box.min.x + x * size.x, box.max.y, box.min.z + z * size.z};
  }

  /// The highest point of the rock below the top of the bounds.
  std::optional<Vec3d> on_surface() {
    Vec3d point = in_plan();
    const Box3d& box = rock_.geology().bounds;
    if (!rock_.geology().solid) return point;
    constexpr int kSteps = 256;
    for (int i = 0; i <= kSteps; ++i) {
      point.y = box.max.y - (box.max.y - box.min.y) * i / kSteps;
      if (rock_.contains(point)) return point;
    }
    return std::nullopt;
  }

  /// A point on a random bed, in a permeable ball, or anywhere if there are neither.
  std::optional<Vec3d> in_rock() {
    const Geology& g = rock_.geology();
    Vec3d point = in_plan();
    const auto beds = static_cast<uint32_t>(g.beds.size());
    const auto balls = static_cast<uint32_t>(g.permeable.size());
    if (beds + balls > 0) {
      const uint32_t choice = random_.below(beds + balls);
      if (choice < beds) {
        point.y = g.beds[choice].height_at(point.x, point.z);
      } else {
        const PermeableBall& ball = g.permeable[choice - beds];
        const Vec3d offset(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1));
        point = ball.center + offset * (0.8 * ball.radius);
      }
    } else {
      point.y = random_.uniform(g.bounds.min.y, g.bounds.max.y);
    }
    return rock_.contains(point) ? std::optional(point) : std::nullopt;
  }

  /// A point on a water table, far on the side to which it falls; for a level one a random side.
  std::optional<Vec3d> at_table(int tier) {
    const Geology& g = rock_.geology();
    const double azimuth = g.water_tables.empty() || g.water_tables[size_t(tier)].dip == 0
                               ? random_.uniform(0, 2 * kPi)
                               : g.water_tables[size_t(tier)].dip_azimuth;
    const Vec3d towards = strike_vector(azimuth);
    Vec3d best = in_plan();
    for (int i = 0; i < 2 * kCandidates; ++i) {
      const Vec3d other = in_plan();
      if (other.dot(towards) > best.dot(towards)) best = other;
    }
    best.y = rock_.table_height(tier, best);
    return rock_.contains(best) ? std::optional(best) : std::nullopt;
  }

  /// Calls `draw` until it returns a point; throws if it never does.
  template <class Draw>
  Vec3d require(const Draw& draw, const char* what) {
    for (int i = 0; i < kTries; ++i)
      if (const std::optional<Vec3d> point = draw()) return *point;
    throw Error(ErrorCode::bad_input, fmt::format("no place for a {} was found in the rock", what),
                {}, "give its position, or check 'from', 'to', 'rock' and the water tables");
  }

  /// The one of several random points that is farthest from those that exist.
  template <class Draw>
  Vec3d spread(const std::vector<Vec3d>& existing, const Draw& draw, const char* what) {
    Vec3d best(0.0);
    double farthest = -1;
    for (int i = 0; i < kCandidates; ++i) {
      const Vec3d point = require(draw, what);
      double nearest = kInfinity;
      for (const Vec3d& other : existing) nearest = std::min(nearest, (other - point).length());
      if (nearest > farthest) best = point;
      farthest = std::max(farthest, nearest);
    }
    return best;
  }

 private:
  const Rock& rock_;
  RandomStream random_;
};

}  // namespace

KeyPoints key_points(const Rock& rock, const KarstOptions& options) {
  const Geology& g = rock.geology();
  KeyPoints keys{g.sinks, g.springs, g.entrances, g.waypoints};
  RandomPoints random(rock, RandomKey(options.seed).at("key points"));
  std::vector<Vec3d> placed;
  if (keys.sinks.empty())
    for (int i = 0; i < options.growth.sinks; ++i) {
      placed.push_back(random.spread(
          placed, [&] { return random.on_surface(); }, "sink"));
      keys.sinks.push_back({.position = placed.back()});
    }
  if (keys.springs.empty() && !keys.sinks.empty())
    for (int tier = 0; tier < rock.tiers(); ++tier)
      keys.springs.push_back(
          {.position = random.require([&] { return random.at_table(tier); }, "spring"),
           .tier = tier});
  placed.clear();
  if (keys.waypoints.empty())
    for (int i = 0; i < options.growth.waypoints; ++i) {
      placed.push_back(random.spread(
          placed, [&] { return random.in_rock(); }, "waypoint"));
      keys.waypoints.push_back(placed.back());
    }
  if (keys.sinks.size() + keys.springs.size() + keys.waypoints.size() < 2)
    throw Error(ErrorCode::bad_input, "a karst network needs at least two key points", {},
                "add a sink and a spring, or two waypoints");
  for (size_t i = 0; i < keys.sinks.size(); ++i)
    if (keys.sinks[i].name.empty()) keys.sinks[i].name = fmt::format("sink.{}", i + 1);
  for (size_t i = 0; i < keys.springs.size(); ++i)
    if (keys.springs[i].name.empty()) keys.springs[i].name = fmt::format("spring.{}", i + 1);
  return keys;
}

}  // namespace vug::karst
