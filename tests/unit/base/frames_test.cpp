// SPDX-License-Identifier: Apache-2.0
#include <vug/base/bezier.h>
#include <vug/base/frames.h>
#include <vug/base/maths.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

/// The maximum deviation of the frames from orthonormality.
double slack(const std::vector<Frame>& frames) {
  double most = 0;
  for (const Frame& f : frames)
    most = std::max({most, (f.tangent.cross(f.normal) - f.binormal).length(),
                     std::fabs(f.normal.length() - 1), std::fabs(f.tangent.dot(f.normal))});
  return most;
}

// On a planar curve the plane's normal is transported to itself: any rotation of it is twist.
TEST(Frames, NoTwistOnAPlanarCurve) {
  const ArcBezier arc(Bezier{{Vec3d(0), Vec3d(0, 6, 2), Vec3d(0, 11, 3), Vec3d(0, 10, 9)}});
  std::vector<Vec3d> points, tangents;
  for (int i = 0; i <= 60; ++i) {
    points.push_back(arc.point(arc.length() * i / 60));
    tangents.push_back(arc.tangent(arc.length() * i / 60));
  }
  const Frame first = Frame{tangents[0], Vec3d(1, 0, 0), Vec3d(0)}.orthonormalized();
  const auto frames = rotation_minimising(points, tangents, first);
  for (const Frame& f : frames) EXPECT_LT(std::hypot(f.normal.y, f.normal.z), 1e-6);
  EXPECT_LT(slack(frames), 1e-14);
}

/// The error angle of the frame after three turns of a helix; the exact frame rotates against the
/// Frenet frame by the torsion times the length.
double helix_error(int steps) {
  const double radius = 1, pitch = 0.5, speed = std::hypot(radius, pitch), end = 6 * kPi;
  const auto frenet = [&](double t) {
    Frame f;
    f.tangent = Vec3d(-radius * std::sin(t), radius * std::cos(t), pitch) / speed;
    f.normal = Vec3d(-std::cos(t), -std::sin(t), 0);
    return f.orthonormalized();
  };
  std::vector<Vec3d> points, tangents;
  for (int i = 0; i <= steps; ++i) {
    const double t = end * i / steps;
    points.emplace_back(radius * std::cos(t), radius * std::sin(t), pitch * t);
    tangents.push_back(frenet(t).tangent);
  }
  const Frame last = rotation_minimising(points, tangents, frenet(0)).back();
  const double torsion = pitch / (speed * speed);
  const Vec3d wanted = frenet(end).around(-torsion * speed * end);
  return std::atan2(wanted.cross(last.normal).length(), wanted.dot(last.normal));
}

TEST(Frames, FourthOrderOnAHelix) {
  const double coarse = helix_error(100), middle = helix_error(200), fine = helix_error(400);
  EXPECT_LT(coarse, 0.02);
  EXPECT_NEAR(std::log2(coarse / middle), 4, 0.1);
  EXPECT_NEAR(std::log2(middle / fine), 4, 0.2);
}

TEST(Frames, RotatesByTheRightHandRule) {
  const Frame f = level_frame({0, 1, 0});
  EXPECT_EQ(f.normal, Vec3d(1, 0, 0));
  const Frame t = f.rotated(f.tangent, kPi / 2);
  EXPECT_LT((t.normal - f.binormal).length(), 1e-15);
  EXPECT_LT((f.around(kPi / 2) - f.binormal).length(), 1e-15);
}

TEST(Frames, CoincidentPointsAndReversalsStayOrthonormal) {
  const Frame f = level_frame({0, 1, 0});
  EXPECT_LT(slack({transported(f, Vec3d(0), Vec3d(0), Vec3d(0, 1, 0)),
                   transported(f, Vec3d(0), Vec3d(0, 1, 0), Vec3d(0, -1, 0)),
                   transported(f, Vec3d(0), Vec3d(0, -1, 0), Vec3d(0, -1, 0))}),
            1e-12);
}

}  // namespace
}  // namespace vug
