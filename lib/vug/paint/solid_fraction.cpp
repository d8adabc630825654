// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/paint/solid_fraction.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::paint {
namespace {

constexpr int kPairs = 48;

/// Half of a point set in the unit ball; the other half are the opposite points. Opposite points
/// cancel on any plane through the centre, so flat rock gives exactly 1/2.
std::array<Vec3d, kPairs> half_ball() {
  constexpr double kGolden = 0.6180339887498949;   // turns between consecutive directions
  constexpr double kPlastic = 0.7548776662466927;  // radii, independent of the directions
  std::array<Vec3d, kPairs> points;
  for (int i = 0; i < kPairs; ++i) {
    const double z = (i + 0.5) / kPairs, ring = std::sqrt(1 - z * z);
    const double turn = 2 * kPi * kGolden * i, u = 0.5 + kPlastic * i;
    const double radius = maths::pow(u - std::floor(u), 1.0 / 3);  // uniform in volume
    points[static_cast<size_t>(i)] =
        Vec3d(ring * maths::cos(turn), ring * maths::sin(turn), z) * radius;
  }
  return points;
}

}  // namespace

double solid_fraction(const EvalPoint& point, double radius) {
  static const std::array<Vec3d, kPairs> kOffsets = half_ball();
  if (!point.solid) return 0.5;
  if (point.to_solid) {
    EvalPoint there = point;
    there.position = point.to_solid->point(point.position);
    there.to_solid = nullptr;
    const double shrink = maths::pow(std::fabs(point.to_solid->determinant()), 1.0 / 3);
    return solid_fraction(there, radius * shrink);
  }
  // Points near the surface count fractionally; a few points would give coarse steps otherwise.
  const double soft = std::min(radius / 6, point.solid->band());
  const auto solid = [&](const Vec3d& p) {
    return 0.5 - 0.5 * std::clamp(point.solid->sample(p).value / soft, -1.0, 1.0);
  };
  double sum = 0;
  for (const Vec3d& offset : kOffsets)
    sum += solid(point.position + offset * radius) + solid(point.position - offset * radius);
  return sum / (2 * kPairs);
}

}  // namespace vug::paint
