// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/passages/curves/star_outline.h>
#include <vug/passages/polygon_section.h>

#include <algorithm>

namespace vug::passages {
namespace {

constexpr int kCornersOfStar = 48;
constexpr int kMostSteps = 100;
constexpr double kNearWall = 1e-6;     ///< Metres.
constexpr double kLeastRadius = 0.02;  ///< Metres.

Vec2d direction_of(int corner) {
  const double angle = 2 * kPi * corner / kCornersOfStar;
  return {maths::cos(angle), maths::sin(angle)};
}

}  // namespace

StarOutline star_outline(const Section& section) {
  StarOutline out;
  for (int i = 0; i < kCornersOfStar; ++i) {
    const Vec2d direction = direction_of(i);
    double radius = section.traits().core;
    for (int step = 0; step < kMostSteps; ++step) {
      const double distance = section.distance(direction.x * radius, direction.y * radius);
      if (distance > -kNearWall) break;
      radius -= distance;
    }
    out.push_back(std::max(radius, kLeastRadius));
  }
  return out;
}

SectionPtr blended_section(const StarOutline& a, const StarOutline& b, double share) {
  std::vector<Vec2d> corners;
  for (int i = 0; i < kCornersOfStar; ++i) {
    const auto k = static_cast<size_t>(i);
    corners.push_back(direction_of(i) * (a[k] + (b[k] - a[k]) * share));
  }
  return polygon_section(corners);
}

}  // namespace vug::passages
