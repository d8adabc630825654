// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/distance_to_wall.h>
#include <vug/passages/survey_line.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kClearance = 0.1;    ///< Metres between a station and the wall.
constexpr double kShortestLeg = 0.1;  ///< Metres between a bend and its neighbours.
constexpr int kMostSteps = 64;
constexpr int kLevels = 7;  ///< Halvings of a leg.

}  // namespace

std::optional<Vec3d> Air::nearest(const Vec3d& point, double reach) const {
  const double sign = negative_ ? -1 : 1;
  Vec3d at = point, best = point;
  double deepest = -kInfinity;
  for (int step = 0; step < kMostSteps; ++step) {
    const field::Gradient here = field_.gradient(at);
    const double depth = sign * here.value, slope = here.gradient.length();
    if (!std::isfinite(depth) || (at - point).length() > reach) break;
    if (depth > deepest) best = at;
    deepest = std::max(deepest, depth);
    if (depth >= kClearance || !(slope > 0)) break;
    // Where the field rises less than the distance, the steps are larger than the missing depth.
    const double missing = kClearance - depth + 0.01;
    at += here.gradient * (sign * missing / (slope * std::clamp(slope, 0.25, 1.0)));
  }
  return contains(best) ? std::optional(best) : std::nullopt;
}

bool Air::sees(const Vec3d& from, const Vec3d& to) const {
  const Vec3d way = to - from;
  const double length = way.length();
  return !(length > 0) || !distance_to_wall(field_, from, way / length, length);
}

std::vector<Vec3d> Air::bends(const Vec3d& from, const Vec3d& to, double reach) const {
  std::vector<Vec3d> all;
  add_bends(from, to, reach, kLevels, all);
  // Each bend is the last of those ahead that the one before sees.
  std::vector<Vec3d> needed;
  for (size_t next = 0; next < all.size();) {
    const Vec3d at = needed.empty() ? from : needed.back();
    if (sees(at, to)) break;
    size_t last = all.size() - 1;
    while (last > next && !sees(at, all[last])) --last;
    needed.push_back(all[last]);
    next = last + 1;
  }
  return needed;
}

/// Returns whether a line of sight leads from one end to the other; adds nothing if no part of the
/// way has one.
bool Air::add_bends(const Vec3d& from, const Vec3d& to, double reach, int levels,
                    std::vector<Vec3d>& points) const {
  const Vec3d way = to - from;
  const double length = way.length();
  if (!(length > 0)) return true;
  const Vec3d direction = way / length;
  const std::optional<double> ahead = distance_to_wall(field_, from, direction, length);
  if (!ahead) return true;
  const std::optional<double> back = distance_to_wall(field_, to, -direction, length);
  if (levels == 0 || !back) return false;
  const double middle = 0.5 * (*ahead + length - *back);
  const std::optional<Vec3d> bend = nearest(from + direction * middle, reach);
  if (!bend || (*bend - from).length() < kShortestLeg || (*bend - to).length() < kShortestLeg)
    return false;
  std::vector<Vec3d> before, after;
  const bool first = add_bends(from, *bend, reach, levels - 1, before);
  const bool second = add_bends(*bend, to, reach, levels - 1, after);
  if (!first && !second) return false;
  points.insert(points.end(), before.begin(), before.end());
  points.push_back(*bend);
  points.insert(points.end(), after.begin(), after.end());
  return first && second;
}

}  // namespace vug::passages
