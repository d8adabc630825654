// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/trs.h>

#include <gtest/gtest.h>

namespace vug::exchange {
namespace {

Transform made_of(const TrsTransform& p) {
  const Vec3d q(p.rotation[0], p.rotation[1], p.rotation[2]);
  const double w = p.rotation[3];
  const auto turned = [&](const Vec3d& v) {
    const Vec3d t = q.cross(v) * 2.0;
    return v + t * w + q.cross(t);
  };
  return {turned({p.scale.x, 0, 0}), turned({0, p.scale.y, 0}), turned({0, 0, p.scale.z}),
          p.translation};
}

TEST(TrsTransform, RecomposesDecomposedTransforms) {
  const Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, -3}, {-1, 1, 1}};
  for (const Vec3d& axis : axes)
    for (const double angle : {0.0, 0.3, 0.5 * kPi, 3.0, kPi, 4.5})
      for (const double side : {1.0, -1.0}) {
        const Transform map = Transform::translation({1, -2, 3}) *
                              Transform::rotation(axis, angle) *
                              Transform::scaling({2, 0.5, side * 3});
        const auto parts = decompose_trs(map);
        ASSERT_TRUE(parts);
        const Transform again = made_of(*parts);
        for (int i = 0; i < 3; ++i)
          EXPECT_LT((again.column(i) - map.column(i)).length(), 1e-14 * 10) << angle;
        EXPECT_EQ(again.origin(), map.origin());
      }
}

TEST(TrsTransform, IsNotDefinedForAShear) {
  const Transform map = Transform::scaling({1, 2, 1}) * Transform::rotation({0, 0, 1}, 0.5);
  EXPECT_FALSE(decompose_trs(map));
}

TEST(TrsTransform, MatricesHoldColumns) {
  const auto m = matrix(Transform({1, 2, 3}, {0, 5, 6}, {0, 0, 9}, {10, 11, 12}));
  const std::array<double, 16> expected = {1, 2, 3, 0, 0, 5, 6, 0, 0, 0, 9, 0, 10, 11, 12, 1};
  EXPECT_EQ(m, expected);
}

}  // namespace
}  // namespace vug::exchange
