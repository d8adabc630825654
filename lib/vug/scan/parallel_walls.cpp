// SPDX-License-Identifier: Apache-2.0
#include <vug/scan/footprint.h>
#include <vug/scan/parallel_walls.h>

#include <algorithm>
#include <cmath>

namespace vug::scan {
namespace {

constexpr double kReach = 2;  ///< Metres.
constexpr size_t kBinsPerTolerance = 5;
constexpr size_t kSlab = 2 * kBinsPerTolerance + 1;
/// Points of a wall relative to the slab in front of it or behind it: rooms, trees and clouds
/// without a facade have about as many everywhere.
constexpr double kMinContrast = 2;
constexpr double kMinWallShare = 0.1;   ///< Points of a wall relative to those of the plane.
constexpr double kMinWallHeight = 0.5;  ///< Height of a wall relative to that of the plane.
constexpr double kMinWallWidth = 1;     ///< Metres.

/// Numbers of points by distance from the plane.
struct Histogram {
  double bin = 0;
  std::vector<size_t> counts;

  /// Number of points within the tolerance of bin i; 0 beyond the end.
  size_t slab(size_t i) const {
    size_t points = 0;
    for (size_t k = i < kBinsPerTolerance ? 0 : i - kBinsPerTolerance;
         k <= i + kBinsPerTolerance && k < counts.size(); ++k)
      points += counts[k];
    return points;
  }
  double center(size_t i) const { return (static_cast<double>(i) + 0.5) * bin - kReach; }
};

Histogram distances(const PointCloud& cloud, const PlaneFit& plane) {
  Histogram out;
  out.bin = plane.tolerance / kBinsPerTolerance;
  out.counts.assign(static_cast<size_t>(std::ceil(2 * kReach / out.bin)), 0);
  for (const Vec3d& position : cloud.positions) {
    const double at = (plane.frame.local(position).z + kReach) / out.bin;
    if (at >= 0 && at < static_cast<double>(out.counts.size()))
      ++out.counts[static_cast<size_t>(at)];
  }
  return out;
}

}  // namespace

std::vector<double> parallel_walls(const PointCloud& cloud, const PlaneFit& plane) {
  std::vector<double> walls = {0};
  const auto slab = [&](double wall) {
    return extent(on_plane(cloud, plane.frame,
                           [&](double z) { return std::fabs(z - wall) <= plane.tolerance; }))
        .size();
  };
  if (!(plane.tolerance < kReach)) return walls;
  const Vec2d main = slab(0);
  const Histogram histogram = distances(cloud, plane);
  std::vector<std::pair<size_t, double>> slabs;  // Numbers of points and distances.
  for (size_t i = 0; i < histogram.counts.size(); ++i) {
    const size_t points = histogram.slab(i);
    const size_t around =
        std::min(i < kSlab ? 0 : histogram.slab(i - kSlab), histogram.slab(i + kSlab));
    if (static_cast<double>(points) >= kMinWallShare * static_cast<double>(plane.inliers) &&
        static_cast<double>(points) >= kMinContrast * static_cast<double>(around))
      slabs.emplace_back(points, histogram.center(i));
  }
  std::stable_sort(slabs.begin(), slabs.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<double> rejected;
  const auto near = [&](const std::vector<double>& known, double depth, double distance) {
    return std::any_of(known.begin(), known.end(),
                       [&](double at) { return std::fabs(depth - at) <= distance; });
  };
  for (const auto& [points, depth] : slabs) {
    if (near(walls, depth, 2 * plane.tolerance) || near(rejected, depth, plane.tolerance)) continue;
    const Vec2d size = slab(depth);
    const bool wall = size.x >= kMinWallWidth && size.y >= kMinWallHeight * main.y;
    (wall ? walls : rejected).push_back(depth);
  }
  std::sort(walls.begin(), walls.end());
  return walls;
}

}  // namespace vug::scan
