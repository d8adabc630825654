// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/karst/joints.h>

#include <algorithm>
#include <cmath>

namespace vug::karst {
namespace {

/// Largest displacement of a joint from its mean position, in spacings; below 0.5, so that the
/// order of joints remains.
constexpr double kJitter = 0.35;

}  // namespace

Vec3d strike_vector(double azimuth) { return {maths::sin(azimuth), 0, -maths::cos(azimuth)}; }

Vec3d plane_normal(double azimuth, double dip) {
  // The horizontal direction to the right of the strike, tilted up by the complement of the dip.
  const Vec3d right = strike_vector(azimuth + kPi / 2);
  return right * maths::sin(dip) + Vec3d(0, maths::cos(dip), 0);
}

double Joints::offset(int64_t joint) const {
  RandomStream random(key_.at(static_cast<uint64_t>(joint)));
  return (static_cast<double>(joint) + random.uniform(-kJitter, kJitter)) * family_.spacing;
}

int64_t Joints::nearest(const Vec3d& point) const {
  return std::llround(point.dot(normal_) / family_.spacing);
}

double Joints::distance(const Vec3d& point) const {
  const double along = point.dot(normal_);
  const int64_t middle = nearest(point);
  double least = kInfinity;
  for (int64_t joint = middle - 1; joint <= middle + 1; ++joint)
    least = std::min(least, std::abs(along - offset(joint)));
  return least;
}

}  // namespace vug::karst
