// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/displacement.h>
#include <vug/mesh/shapes.h>

#include <gtest/gtest.h>

namespace vug::mesh {
namespace {

/// A flat square of side 1 m of 2 n n triangles.
Mesh sheet(uint32_t n) {
  Mesh mesh;
  for (uint32_t i = 0; i <= n; ++i)
    for (uint32_t k = 0; k <= n; ++k)
      mesh.positions.emplace_back(static_cast<float>(k) / static_cast<float>(n), 0.0f,
                                  static_cast<float>(i) / static_cast<float>(n));
  for (uint32_t i = 0; i < n; ++i)
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t a = i * (n + 1) + k, b = a + n + 1;
      mesh.triangles.push_back({a, b, a + 1});
      mesh.triangles.push_back({a + 1, b, b + 1});
    }
  return mesh;
}

TEST(Displacement, AShrunkenBallMovedFarWithoutFlips) {
  const Mesh ball = sphere_mesh(Vec3d(1, 2, 3), 2, 3);
  Mesh moved = ball;
  EXPECT_EQ(max_displacement(ball, moved), 0);
  for (Vec3f& p : moved.positions) p = Vec3f(1, 2, 3) + (p - Vec3f(1, 2, 3)) * 0.25f;
  const Mesh shrunken = moved;
  EXPECT_NEAR(max_displacement(ball, moved), 1.5, 1e-6);
  EXPECT_TRUE(folded_triangles(ball.positions, moved).empty());
  EXPECT_EQ(prevent_folds(ball.positions, moved, true), 0U);
  EXPECT_EQ(moved, shrunken);
}

TEST(Displacement, AFoldIsFound) {
  // Two triangles that share an edge; the corner of one moves across it to the other side.
  Mesh folded = sheet(1);
  const std::vector<Vec3f> flat = folded.positions;
  folded.positions[3] = Vec3f(0.1f, 0, 0.1f);
  EXPECT_EQ(folded_triangles(flat, folded), std::vector<uint32_t>{1});
}

TEST(Displacement, ATipPressedFlatIsNotAFold) {
  // The sides of a steep cone turn by more than 90 degrees if its apex moves below its rim.
  Mesh cone;
  cone.positions = {{0, 1, 0}, {0.1f, 0, 0}, {0, 0, 0.1f}, {-0.1f, 0, 0}, {0, 0, -0.1f}};
  cone.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}};
  Mesh pressed = cone;
  pressed.positions[0].y = -0.1f;
  EXPECT_EQ(flipped_triangles(cone.positions, pressed).size(), 4U);
  EXPECT_TRUE(folded_triangles(cone.positions, pressed).empty());
}

TEST(Displacement, IsChangedOnlyWhereItFolds) {
  // The vertices at x > 0.5 move to the left, those at 0.75 past their neighbours.
  Mesh folded = sheet(20);
  const std::vector<Vec3f> flat = folded.positions;
  for (Vec3f& p : folded.positions) p += Vec3f(p.x > 0.7f ? -0.12f : 0, p.x > 0.5f ? 0.3f : 0, 0);
  ASSERT_FALSE(folded_triangles(flat, folded).empty());
  const std::vector<Vec3f> full = folded.positions;
  const size_t changed = prevent_folds(flat, folded, false);
  EXPECT_TRUE(folded_triangles(flat, folded).empty());
  size_t different = 0;
  for (size_t v = 0; v < full.size(); ++v) {
    different += folded.positions[v] != full[v];
    if (flat[v].x < 0.5f) {
      ASSERT_EQ(folded.positions[v], full[v]);
    }
  }
  EXPECT_EQ(changed, different);
}

}  // namespace
}  // namespace vug::mesh
