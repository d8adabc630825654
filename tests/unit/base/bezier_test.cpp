// SPDX-License-Identifier: Apache-2.0
#include <vug/base/bezier.h>
#include <vug/base/error.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

const Bezier kWild{{Vec3d(0, 0, 0), Vec3d(0, 4, 1), Vec3d(-3, 5, 2), Vec3d(2, 1, -1)}};

/// Lengths of the chords and of the control polygons of a subdivision: bounds of the curve's
/// length.
void bracket(const Bezier& curve, int depth, double& low, double& high) {
  if (depth > 0) {
    for (const Bezier& half : curve.split(0.5)) bracket(half, depth - 1, low, high);
    return;
  }
  low += (curve.control[3] - curve.control[0]).length();
  for (size_t i = 0; i < 3; ++i) high += (curve.control[i + 1] - curve.control[i]).length();
}

TEST(Bezier, LengthLiesBetweenChordsAndPolygon) {
  double low = 0, high = 0;
  bracket(kWild, 14, low, high);
  const double length = ArcBezier(kWild).length();
  EXPECT_LT(high - low, 1e-7);
  EXPECT_GE(length, low - 1e-12);
  EXPECT_LE(length, high + 1e-12);
}

// y = x^2 from 0 to 1 as a cubic: length sqrt(5)/2 + asinh(2)/4.
TEST(Bezier, LengthOfAParabola) {
  const Bezier parabola{{Vec3d(0), Vec3d(1. / 3, 0, 0), Vec3d(2. / 3, 1. / 3, 0), Vec3d(1, 1, 0)}};
  EXPECT_NEAR(ArcBezier(parabola).length(), std::sqrt(5) / 2 + std::asinh(2) / 4, 1e-13);
}

TEST(Bezier, ParameterInvertsLength) {
  const ArcBezier arc(kWild);
  for (int i = 0; i <= 1000; ++i) {
    const double along = arc.length() * i / 1000;
    EXPECT_NEAR(arc.length_to(arc.parameter(along)), along, 1e-12);
  }
  EXPECT_EQ(arc.parameter(-1), 0);
  EXPECT_EQ(arc.parameter(1e9), 1);
}

TEST(Bezier, ParameterOfAStraightUniformCurveIsProportional) {
  const ArcBezier arc(Bezier{{Vec3d(0), Vec3d(0, 1, 0), Vec3d(0, 2, 0), Vec3d(0, 3, 0)}});
  EXPECT_NEAR(arc.length(), 3, 1e-14);
  EXPECT_NEAR(arc.parameter(0.75), 0.25, 1e-13);
}

TEST(Bezier, DerivativesMatchThePoint) {
  const double h = 1e-5;
  for (const double t : {0.1, 0.4, 0.8}) {
    const Vec3d first = (kWild.point(t + h) - kWild.point(t - h)) / (2 * h);
    const Vec3d second = (kWild.derivative(t + h) - kWild.derivative(t - h)) / (2 * h);
    EXPECT_LT((first - kWild.derivative(t)).length(), 1e-8);
    EXPECT_LT((second - kWild.second(t)).length(), 1e-8);
  }
}

TEST(Bezier, EndsWithZeroSpeedHaveATangent) {
  const Bezier rests{{Vec3d(0), Vec3d(0), Vec3d(1, 0, 0), Vec3d(1, 1, 0)}};
  EXPECT_LT((rests.tangent(0) - Vec3d(1, 0, 0)).length(), 1e-12);
  const Bezier line{{Vec3d(0), Vec3d(0), Vec3d(0, 2, 0), Vec3d(0, 2, 0)}};
  EXPECT_LT((line.tangent(0) - Vec3d(0, 1, 0)).length(), 1e-12);
  EXPECT_LT((line.tangent(1) - Vec3d(0, 1, 0)).length(), 1e-12);
}

TEST(Bezier, DroopingHasTheGivenLengthAndAngles) {
  const double lean = 0.05, tip = 2.0;
  const Bezier stem = drooping(9, lean, tip, 0.7, 0.5);
  EXPECT_NEAR(ArcBezier(stem).length(), 9, 1e-10);
  EXPECT_NEAR(std::acos(stem.tangent(0).y), lean, 1e-12);
  EXPECT_NEAR(std::acos(stem.tangent(1).y), tip, 1e-12);
  EXPECT_NEAR(std::atan2(-stem.tangent(1).z, stem.tangent(1).x), 0.7, 1e-12);
}

TEST(Bezier, RejectsInvalidCurves) {
  const Vec3d p(1, 2, 3);
  EXPECT_THROW(ArcBezier(Bezier{{p, p, p, p}}), Error);
  EXPECT_THROW(ArcBezier(Bezier{{p, p, p, Vec3d(std::nan(""), 0, 0)}}), Error);
  EXPECT_THROW(drooping(0, 0, 1, 0, 0.5), Error);
  EXPECT_THROW(drooping(1, 0, 1, 0, 1), Error);
}

}  // namespace
}  // namespace vug
