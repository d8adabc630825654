// SPDX-License-Identifier: Apache-2.0
#include <vug/base/disjoint_sets.h>
#include <vug/scan/bins.h>
#include <vug/scan/footprint.h>

namespace vug::scan {

namespace {
constexpr double kGap = 1.0;  ///< Side length of bins in metres; bins that touch are connected.
}

std::vector<Vec2d> on_plane(const PointCloud& cloud, const PlaneFrame& frame,
                            const std::function<bool(double)>& accepts) {
  std::vector<Vec2d> out;
  for (const Vec3d& position : cloud.positions) {
    const Vec3d p = frame.local(position);
    if (accepts(p.z)) out.emplace_back(p.x, p.y);
  }
  return out;
}

Imath::Box2d extent(const std::vector<Vec2d>& points) {
  const Bins bins = bin_points(points, kGap);
  DisjointSets<> groups(bins.keys.size());
  for (size_t i = 0; i < bins.keys.size(); ++i)
    for (const BinKey& step : {BinKey{0, 1}, {1, -1}, {1, 0}, {1, 1}}) {
      const int64_t other =
          bins.find({bins.keys[i].first + step.first, bins.keys[i].second + step.second});
      if (other >= 0) groups.join(static_cast<uint32_t>(i), static_cast<uint32_t>(other));
    }
  std::vector<size_t> sizes(bins.keys.size(), 0);
  for (size_t i = 0; i < sizes.size(); ++i)
    sizes[groups.root(static_cast<uint32_t>(i))] += bins.counts[i];
  const auto largest =
      static_cast<uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  Imath::Box2d box;
  for (size_t i = 0; i < points.size(); ++i)
    if (groups.root(bins.bin_of_point[i]) == largest) box.extendBy(points[i]);
  return box;
}

}  // namespace vug::scan
