// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/karst/shape.h>

#include <algorithm>
#include <cmath>

namespace vug::karst {
namespace {

constexpr int kMostLevels = 8;     ///< Halvings of a passage.
constexpr double kVertical = 0.3;  ///< Vertical displacement as a fraction of the horizontal one.
constexpr double kMostNormal = 2;  ///< Standard deviations.

double bounded_normal(RandomStream& random) {
  return std::clamp(random.normal(), -kMostNormal, kMostNormal);
}

/// Splits all legs longer than the option in their middle, and moves it sideways, until none is.
void wander(std::vector<Vec3d>& points, const ShapeOptions& o, double amount,
            RandomStream& random) {
  for (int level = 0; level < kMostLevels; ++level) {
    std::vector<Vec3d> finer{points.front()};
    for (size_t i = 1; i < points.size(); ++i) {
      const Vec3d way = points[i] - points[i - 1];
      const double length = way.length();
      if (length > o.leg_length) {
        Vec3d aside(way.z, 0, -way.x);
        if (aside.length2() < 1e-6 * length * length)
          aside = strike_vector(random.uniform(0, 2 * kPi));
        const Vec3d offset = aside.normalized() * bounded_normal(random) +
                             Vec3d(0, kVertical * bounded_normal(random), 0);
        finer.push_back((points[i] + points[i - 1]) * 0.5 + offset * (amount * length));
      }
      finer.push_back(points[i]);
    }
    if (finer.size() == points.size()) return;
    points = std::move(finer);
  }
}

/// The shortest way along two strikes whose sum is the horizontal part of a vector.
struct Steps {
  Vec3d first{0.0};
  Vec3d second{0.0};
  double spread = 0;  ///< Spread of the directions, radians.
};

std::optional<Steps> steps_along_joints(const Vec3d& way, const Rock& rock) {
  std::optional<Steps> best;
  double least = kInfinity;
  const auto& joints = rock.joints();
  for (size_t i = 0; i < joints.size(); ++i)
    for (size_t j = i + 1; j < joints.size(); ++j) {
      const Vec3d u = strike_vector(joints[i].family().azimuth);
      const Vec3d v = strike_vector(joints[j].family().azimuth);
      const double cross = u.x * v.z - u.z * v.x;
      if (std::abs(cross) < 0.2) continue;  // The strikes are nearly parallel.
      const double along_u = (way.x * v.z - way.z * v.x) / cross;
      const double along_v = (u.x * way.z - u.z * way.x) / cross;
      if (std::abs(along_u) + std::abs(along_v) >= least) continue;
      least = std::abs(along_u) + std::abs(along_v);
      best = Steps{u * along_u, v * along_v,
                   (joints[i].family().spread + joints[j].family().spread) / 2};
    }
  return best;
}

/// The points between which a passage follows joints; the ends are those of the passage.
std::vector<Vec3d> zigzag(const Vec3d& from, const Vec3d& to, Steps steps, const ShapeOptions& o,
                          RandomStream& random) {
  const Vec3d way = to - from;
  if (random.uniform() < 0.5) std::swap(steps.first, steps.second);
  const double length = steps.first.length() + steps.second.length();
  const int count = std::max(1, static_cast<int>(std::lround(length / (3 * o.leg_length))));
  std::vector<Vec3d> points{from};
  Vec3d plan = from;
  for (int i = 0; i < 2 * count; ++i) {
    const Vec3d& step = i % 2 == 0 ? steps.first : steps.second;
    plan += step / count;
    if (step.length() < 0.05 * length) continue;
    Vec3d point = plan;
    if (i + 1 < 2 * count) {
      point += Vec3d(bounded_normal(random), 0, bounded_normal(random)) *
               (0.5 * steps.spread * step.length() / count);
      point.y = from.y + way.y * (i + 1) / (2 * count);
    }
    points.push_back(point);
  }
  points.back() = to;
  return points;
}

/// Moves points towards the straight line of the ends, to this part of their distance from it.
void flatten(std::vector<Vec3d>& points, double part) {
  const Vec3d from = points.front();
  const Vec3d way = points.back() - from;
  if (part == 1 || !(way.length2() > 0)) return;
  for (size_t i = 1; i + 1 < points.size(); ++i) {
    const double t = std::clamp((points[i] - from).dot(way) / way.length2(), 0.0, 1.0);
    const Vec3d straight = from + way * t;
    points[i] = straight + (points[i] - straight) * part;
  }
}

/// The horizontal distance from the first point to each one.
std::vector<double> stations_along(const std::vector<Vec3d>& points) {
  std::vector<double> along{0};
  for (size_t i = 1; i < points.size(); ++i) {
    const Vec3d way = points[i] - points[i - 1];
    along.push_back(along.back() + std::sqrt(way.x * way.x + way.z * way.z));
  }
  return along;
}

/// Gentle slopes with pitches between them. The pitches are at points, which they double.
std::vector<Vec3d> with_pitches(const std::vector<Vec3d>& points, const ShapeOptions& o,
                                bool at_end, RandomStream& random) {
  const std::vector<double> along = stations_along(points);
  const double drop = points.front().y - points.back().y;
  const double slope = maths::tan(o.vadose_slope);
  const double excess = drop - slope * along.back();
  if (excess <= 0.1 * o.pitch || points.size() < 3) return points;
  const auto places = static_cast<int>(points.size()) - 1;
  const int count = std::clamp(
      static_cast<int>(std::lround(excess / o.pitch * random.uniform(0.7, 1.3))), 1, places);
  std::vector<bool> drops(points.size(), false);
  drops.back() = at_end;
  for (int left = count - (at_end ? 1 : 0); left > 0;) {
    const auto place = 1 + random.below(static_cast<uint32_t>(places));
    if (drops[place]) continue;
    drops[place] = true;
    --left;
  }
  std::vector<Vec3d> stepped{points.front()};
  double fallen = 0;
  for (size_t i = 1; i < points.size(); ++i) {
    Vec3d point = points[i];
    point.y = points.front().y - slope * along[i] - fallen;
    if (drops[i]) {
      stepped.push_back(point);
      fallen += excess / count;
      point.y -= excess / count;
    }
    stepped.push_back(point);
  }
  stepped.back() = points.back();
  return stepped;
}

/// One loop below the straight line of the ends.
void add_loop(std::vector<Vec3d>& points, const ShapeOptions& o, RandomStream& random) {
  const std::vector<double> along = stations_along(points);
  if (!(along.back() > 0)) return;
  const double depth = o.looping * along.back() * random.uniform(0.3, 1.7);
  for (size_t i = 1; i + 1 < points.size(); ++i)
    points[i].y -= depth * maths::sin(kPi * along[i] / along.back());
}

}  // namespace

std::vector<Vec3d> shape_passage(const network::Leg& leg, const SegmentPiece& ends,
                                 const Rock& rock, const ShapeOptions& options, int attempt,
                                 RandomKey key) {
  std::vector<Vec3d> points{ends.from, ends.to};
  if (attempt + 1 >= kShapeAttempts) return points;
  RandomStream random(attempt == 0 ? key : key.at(static_cast<uint64_t>(attempt)));
  const double amplitude = 1 - static_cast<double>(attempt) / (kShapeAttempts - 1);
  double amount = amplitude * options.wander;
  if (options.zigzag > 0 && random.uniform() < options.zigzag)
    if (const auto steps = steps_along_joints(ends.to - ends.from, rock)) {
      points = zigzag(ends.from, ends.to, *steps, options, random);
      flatten(points, amplitude);
      amount = 0.25 * amplitude * steps->spread;
    }
  wander(points, options, amount, random);
  if (leg.stage == network::Stage::vadose && ends.from.y > ends.to.y)
    return with_pitches(points, options, attempt % 2 == 1, random);
  if (leg.stage == network::Stage::phreatic) add_loop(points, options, random);
  return points;
}

}  // namespace vug::karst
