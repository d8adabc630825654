// SPDX-License-Identifier: Apache-2.0
#include <vug/scan/quality_warnings.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::scan {
namespace {

constexpr double kLowest = 1;  ///< Metres.
/// Points within this many tolerances are near the plane. In a uniform distribution one in as many
/// lies on the plane; on scans of facades two thirds do, even if walls bow.
constexpr double kNear = 10;
constexpr double kMinShare = 0.3;

/// Share of the points near the walls, within the range image, that lie on one of them.
double share_on(const PointCloud& cloud, const PlaneFit& plane, const RangeImage& range) {
  size_t on = 0, near = 0;
  for (const Vec3d& position : cloud.positions) {
    const Vec3d p = range.frame.local(position);
    if (p.x < 0 || p.y < 0 || p.x > range.metres_wide() || p.y > range.metres_high()) continue;
    double apart = kInfinity;
    for (const double wall : plane.walls) apart = std::min(apart, std::abs(p.z - wall));
    near += apart <= kNear * plane.tolerance;
    on += apart <= plane.tolerance;
  }
  return near > 0 ? static_cast<double>(on) / static_cast<double>(near) : 0;
}

}  // namespace

std::vector<QualityWarning> quality_warnings(const PointCloud& cloud, const PlaneFit& plane,
                                             const RangeImage& range) {
  std::vector<QualityWarning> out;
  if (range.metres_high() < kLowest)
    out.push_back({fmt::format("the upright part of the cloud is {:.2f} m high and {:.2f} m wide, "
                               "too low for a facade",
                               range.metres_high(), range.metres_wide()),
                   "it may be a floor or a roof, or --up is the wrong axis"});
  if (const double share = share_on(cloud, plane, range); share < kMinShare)
    out.push_back(
        {fmt::format("only {:.0f} % of the points near the plane lie on it", 100 * share),
         "the cloud may not contain a facade, or the facade is rougher than --tolerance"});
  return out;
}

}  // namespace vug::scan
