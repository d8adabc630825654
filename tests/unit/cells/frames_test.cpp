// SPDX-License-Identifier: Apache-2.0
#include "made.h"

#include <vug/cells/frames.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

Network made(const mesh::Mesh& mesh, const std::string& grid, double spacing) {
  return build(Surface({shared(mesh)}), options(grid, spacing)).network;
}

/// Fraction of the links whose two frames differ by more than the angle after transport.
double torn(const Network& n, double cosine) {
  double bad = 0, all = 0;
  for (uint32_t i = 0; i < n.size(); ++i)
    for (const uint32_t to : n.links.of(i)) {
      const Vec3f here = parallel_transport(n.right[to], n.normal[to], n.normal[i]);
      bad += here.dot(n.right[i]) < static_cast<float>(cosine), ++all;
    }
  return bad / all;
}

TEST(ParallelTransport, RotatesWithTheNormal) {
  const Vec3f x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_LT((parallel_transport(x, z, y) - x).length(), 1e-6f);  // Along the fold: unchanged.
  EXPECT_LT((parallel_transport(y, z, y) + z).length(),
            1e-6f);  // Across the fold: down the other side.
  EXPECT_LT((parallel_transport(x, y, y) - x).length(), 1e-6f);
}

TEST(Frames, AreLevelOnSlopesAndConstantOnAFloor) {
  const Network ball = made(mesh::sphere_mesh(Vec3d(0), 1, 4), "random", 0.05);
  for (uint32_t i = 0; i < ball.size(); ++i) {
    const float sine = std::sqrt(1 - ball.normal[i].y * ball.normal[i].y);
    if (sine < 0.4f) continue;
    ASSERT_NEAR(ball.right[i].y, 0, 1e-5);
    ASSERT_NEAR(ahead(ball, i).y, sine, 1e-4);
    // Seen from outside, right is to the right.
    ASSERT_GT(Vec3f(0, 1, 0).cross(ball.normal[i]).dot(ball.right[i]), 0);
  }
  const Network floor = made(floor_mesh(), "random", 0.03);
  for (const Vec3f& right : floor.right) ASSERT_LT((right - Vec3f(1, 0, 0)).length(), 1e-5f);
}

TEST(Frames, AreContinuousExceptAtFewPoles) {
  // A ball has poles. A flat torus has none, but rings of horizontal ground on top and below that
  // inherit their frames from both slopes, which run in opposite directions.
  const Network ball = made(mesh::sphere_mesh(Vec3d(0), 1, 5), "random", 0.03);
  EXPECT_LT(torn(ball, 0.7), 0.02);
  EXPECT_LT(torn(made(mesh::torus_mesh(1, 0.4, 80, 40), "random", 0.04), 0.7), 0.1);
  // An upright box: its walls agree, its floor and ceiling follow the first wall that reaches them.
  EXPECT_LT(torn(made(mesh::box_mesh({Vec3d(0), Vec3d(1)}), "square", 0.03), 0.7), 0.05);
}

TEST(Neighbours, AreFoundBySide) {
  const Network n = flat_torus(8, 8, 4);
  const uint32_t cell = 3 * 8 + 3;
  EXPECT_EQ(neighbour_at(n, cell, Side::right), cell + 1);
  EXPECT_EQ(neighbour_at(n, cell, Side::left), cell - 1);
  EXPECT_EQ(neighbour_at(n, cell, Side::up), cell - 8);  // y up, x right: z towards the viewer.
  EXPECT_EQ(neighbour_at(n, cell, Side::down), cell + 8);
  EXPECT_EQ(neighbour_toward(n, cell, {0, 1, 0}), std::nullopt);
  EXPECT_EQ(neighbour_toward(n, cell, {2, 5, 1}), cell + 1);
}

TEST(Neighbours, UphillIsHigher) {
  const Network ball = made(mesh::sphere_mesh(Vec3d(0), 1, 4), "random", 0.05);
  for (uint32_t i = 0; i < ball.size(); ++i) {
    if (std::fabs(ball.normal[i].y) > 0.9f) continue;
    const auto up = neighbour_toward(ball, i, {0, 1, 0});
    const auto down = neighbour_toward(ball, i, {0, -1, 0});
    ASSERT_TRUE(up && down);
    ASSERT_GT(ball.position[*up].y, ball.position[i].y);
    ASSERT_LT(ball.position[*down].y, ball.position[i].y);
    ASSERT_EQ(neighbour_at(ball, i, Side::up), up);
  }
}

}  // namespace
}  // namespace vug::cells
