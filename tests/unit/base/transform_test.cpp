// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/transform.h>

#include <gtest/gtest.h>

namespace vug {
namespace {

void expect_near(const Vec3d& a, const Vec3d& b) { EXPECT_LT((a - b).length(), 1e-12) << a << b; }

TEST(Transform, InverseInverts) {
  const Transform t = Transform::translation({1, 2, 3}) * Transform::rotation({1, 1, 0}, 0.7) *
                      Transform::scaling({2, 0.5, 3});
  const Vec3d p(0.3, -1.7, 4);
  expect_near(t.inverse().point(t.point(p)), p);
  EXPECT_NEAR(t.max_stretch(), 3, 1e-12);
  EXPECT_NEAR(t.min_stretch(), 0.5, 1e-12);
}

TEST(Transform, RotationIsRightHanded) {
  expect_near(Transform::rotation({0, 1, 0}, kPi / 2).point({0, 0, 1}), {1, 0, 0});
  expect_near(rotation_between({1, 0, 0}, {0, 0, -1}).point({1, 0, 0}), {0, 0, -1});
  expect_near(rotation_between({1, 0, 0}, {-1, 0, 0}).point({1, 0, 0}), {-1, 0, 0});
}

TEST(Transform, NormalsStayPerpendicular) {
  const Transform t(Vec3d(1, 0, 0), Vec3d(1, 2, 0), Vec3d(0, 0, 3), Vec3d(0));
  const Vec3d along(1, -1, 2), normal(1, 1, 0);
  EXPECT_NEAR(t.vector(along).dot(t.normal(normal)), 0, 1e-12);
}

TEST(Transform, RejectsSingularMaps) { EXPECT_THROW(Transform::scaling({1, 0, 1}), Error); }

}  // namespace
}  // namespace vug
