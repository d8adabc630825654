// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/network/along.h>

#include <cmath>

namespace vug::network {
namespace {

/// A corner of 6 m and 4 m, and a side passage of 1 m at its end.
Network corner() {
  Network network;
  network.stations = {{.position = {0, 0, 0}},
                      {.position = {6, 0, 0}},
                      {.position = {6, 0, 4}},
                      {.position = {6, 1, 4}},
                      {.position = {7, 0, 4}}};
  network.legs = {
      {.from = 0, .to = 1}, {.from = 1, .to = 2}, {.from = 2, .to = 3}, {.from = 2, .to = 4}};
  return network;
}

TEST(PointsAlong, AreEvenAlongEachBranch) {
  const std::vector<Vec3d> points = points_along(corner(), 2);
  // The branch of 10 m has five points, the branches of 1 m have one each, in their middle.
  ASSERT_EQ(points.size(), 7u);
  const std::vector<Vec3d> expected = {{1, 0, 0}, {3, 0, 0},   {5, 0, 0},  {6, 0, 1},
                                       {6, 0, 3}, {6, 0.5, 4}, {6.5, 0, 4}};
  for (size_t i = 0; i < points.size(); ++i)
    EXPECT_LT((points[i] - expected[i]).length(), 1e-12) << i;
}

TEST(PointsAlong, RejectsSpacingsWithoutAnEnd) {
  EXPECT_THROW(points_along(corner(), 0), Error);
  EXPECT_THROW(points_along(corner(), -1), Error);
  EXPECT_THROW(points_along(corner(), std::nan("")), Error);
  EXPECT_THROW(points_along(corner(), 1e-9), Error);
  EXPECT_THROW(points_along(corner(), 1e-5), Error);
  EXPECT_TRUE(points_along({}, 1).empty());
}

}  // namespace
}  // namespace vug::network
