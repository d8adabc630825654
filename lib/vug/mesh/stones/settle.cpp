// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/mesh/stones/settle.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

constexpr int kMostSteps = 60;
constexpr double kLargestSlope = 0.25, kLeastSlope = 2e-3;  // Of one step.
constexpr double kLeastDescent = 1e-6;                      // Of one step, over the reach.

/// Moves a pose down until it touches the ground; false without ground.
bool drop(StonePose& pose, const GapFunction& function, std::vector<Gap>& gaps) {
  gaps.clear();
  function(pose, gaps);
  if (gaps.empty()) return false;
  const double least = std::min_element(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
                         return a.height < b.height;
                       })->height;
  if (!std::isfinite(least)) return false;
  pose.centre.y -= least;
  for (Gap& gap : gaps) gap.height -= least;
  return true;
}

/// Three contacts around the centre of mass, at most `tolerance` below the stone.
std::optional<Rest> supported(const StonePose& pose, std::vector<Gap> gaps, double reach,
                              double tolerance) {
  gaps.erase(std::remove_if(gaps.begin(), gaps.end(),
                            [&](const Gap& gap) { return gap.height > tolerance; }),
             gaps.end());
  std::vector<Gap> flat = gaps;
  for (Gap& gap : flat) gap.height = 0;
  const SupportPlane plane = support_plane(flat, reach, 1);
  if (!plane.is_supported()) return std::nullopt;
  Rest rest;
  rest.pose = pose;
  for (size_t i = 0; i < 3; ++i) {
    const Gap& gap = gaps[static_cast<size_t>(plane.contacts[i])];
    rest.contacts[i] = {pose.centre.x + gap.x, gap.ground, pose.centre.z + gap.z};
  }
  return rest;
}

}  // namespace

Vec3d Rest::contact_area() const {
  const Vec3d across = (contacts[1] - contacts[0]).cross(contacts[2] - contacts[0]);
  return across.y < 0 ? -across : across;
}

std::optional<Rest> settle(StonePose pose, double reach, double tolerance,
                           const GapFunction& function) {
  std::vector<Gap> gaps, next_gaps;
  if (!drop(pose, function, gaps)) return std::nullopt;
  double limit = kLargestSlope;
  for (int step = 0; step < kMostSteps && limit > kLeastSlope; ++step) {
    const SupportPlane plane = support_plane(gaps, reach, limit);
    const Vec3d rotation(plane.slope_z, 0, -plane.slope_x);
    const bool is_last = plane.is_supported() && rotation.length() < kLeastSlope;
    StonePose next = pose.turned(rotation);
    if (!drop(next, function, next_gaps)) return std::nullopt;
    if (next.centre.y < pose.centre.y - kLeastDescent * reach) {
      pose = next;
      std::swap(gaps, next_gaps);
      limit = std::min(kLargestSlope, 1.5 * limit);
    } else {
      limit *= 0.3;
    }
    if (is_last) break;
  }
  return supported(pose, std::move(gaps), reach, tolerance);
}

}  // namespace vug::mesh
