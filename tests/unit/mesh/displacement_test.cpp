// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/displacement.h>
#include <vug/mesh/shapes.h>

#include <gtest/gtest.h>

namespace vug::mesh {
namespace {

TEST(Displacement, AShrunkenBallMovedFarWithoutFlips) {
  const Mesh ball = sphere_mesh(Vec3d(1, 2, 3), 2, 3);
  Mesh moved = ball;
  EXPECT_EQ(max_displacement(ball, moved), 0);
  EXPECT_EQ(flipped_triangles(ball, moved), 0U);
  for (Vec3f& p : moved.positions) p = Vec3f(1, 2, 3) + (p - Vec3f(1, 2, 3)) * 0.25f;
  EXPECT_NEAR(max_displacement(ball, moved), 1.5, 1e-6);
  EXPECT_EQ(flipped_triangles(ball, moved), 0U);
}

TEST(Displacement, AFoldIsCounted) {
  // Two triangles that share an edge; the corner of one moves across it to the other side.
  Mesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
  sheet.triangles = {{0, 2, 1}, {1, 2, 3}};
  Mesh folded = sheet;
  folded.positions[3] = Vec3f(0.1f, 0, 0.1f);
  EXPECT_EQ(flipped_triangles(sheet, folded), 1U);
}

}  // namespace
}  // namespace vug::mesh
