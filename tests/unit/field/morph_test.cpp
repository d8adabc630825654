// SPDX-License-Identifier: Apache-2.0
// The morph against its closed forms (SG+M eq. 5).
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

/// The set |p - f1| + |p - f2| = 2R: a prolate ellipsoid with the centres as foci.
TEST(Morph, TwoEqualSpheresMakeAnEllipsoidWithTheCentresAsFoci) {
  constexpr double voxel = 0.05, radius = 200 * voxel;
  for (const double voxels : {2.0, 5.0, 20.0, 50.0, 100.0, 200.0, 390.0}) {
    const double apart = voxels * voxel;
    const Field ball = make("sphere", {{"radius", radius}});
    const Field half = morph(transformed(ball, Transform::translation({-apart / 2, 0, 0})),
                             transformed(ball, Transform::translation({apart / 2, 0, 0})), 0.5);
    const double a = radius, b = std::sqrt(radius * radius - apart * apart / 4);
    for (double t = 0; t < kPi; t += 0.1) {
      const Vec3d p(a * std::cos(t), b * std::sin(t), 0);
      const Gradient g = half.gradient(p);
      EXPECT_LT(std::fabs(g.value) / g.gradient.length(), 1e-9 * voxel) << voxels << " " << t;
    }
    EXPECT_LT(half.value({0, 0, 0}), 0);
  }
}

TEST(Morph, SpheresTwoRadiiApartGiveAnEmptyMorph) {
  const Field ball = make("sphere");
  for (const double apart : {2.0, 2.5, 20.0}) {
    const Field half = morph(ball, transformed(ball, Transform::translation({apart, 0, 0})), 0.5);
    for (double x = -2; x < apart + 2; x += 0.01)
      for (double y = 0; y < 2; y += 0.25) EXPECT_GE(half.value({x, y, 0}), -1e-12);
  }
}

TEST(Morph, IsAFoldInDerivationOrder) {
  const Field a = make("sphere", {{"radius", 1.0}}), b = make("sphere", {{"radius", 2.0}}),
              c = make("sphere", {{"radius", 4.0}});
  const Field fold = morph(morph(a, b, 0.5), c, 0.25);  // 0.75 * 1.5 + 0.25 * 4
  EXPECT_NEAR(fold.value({2.125, 0, 0}), 0, 1e-15);
  EXPECT_THROW(morph(a, b, 1.5), Error);
}

}  // namespace
}  // namespace vug::field
