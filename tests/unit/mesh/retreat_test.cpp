// SPDX-License-Identifier: Apache-2.0
// Moves that make triangles intersect or fold are shortened, and no others.
#include <vug/base/parallel.h>
#include <vug/mesh/displacement.h>
#include <vug/mesh/folds.h>
#include <vug/mesh/retreat.h>
#include <vug/mesh/self_intersections.h>
#include <vug/mesh/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace vug::mesh {
namespace {

/// Two balls next to each other, 0.2 m apart.
Mesh two_balls() {
  Mesh both = sphere_mesh(Vec3d(-1.1, 0, 0), 1, 3);
  const Mesh other = sphere_mesh(Vec3d(1.1, 0, 0), 1, 3);
  const auto first = static_cast<uint32_t>(both.positions.size());
  both.positions.insert(both.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& t : other.triangles)
    both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  both.normals.clear();
  return both;
}

/// The left ball moves to the right, into the other.
Mesh collided() {
  Mesh mesh = two_balls();
  for (size_t v = 0; v < mesh.positions.size() / 2; ++v) mesh.positions[v].x += 0.5F;
  return mesh;
}

TEST(Retreat, SeparatesSheetsThatWouldCross) {
  const Mesh before = two_balls();
  Mesh mesh = collided();
  const std::vector<Vec3f> full = mesh.positions;
  ASSERT_FALSE(self_intersections(mesh).empty());
  const std::vector<float> shares = retreat(before.positions, mesh);
  EXPECT_TRUE(self_intersections(mesh).empty());
  EXPECT_TRUE(folded_triangles(mesh).empty());
  size_t whole = 0;
  for (size_t v = 0; v < shares.size(); ++v) {
    whole += shares[v] == 1;
    if (shares[v] == 1) {
      EXPECT_EQ(mesh.positions[v], full[v]);
    }
    if (shares[v] == 0) {
      EXPECT_EQ(mesh.positions[v], before.positions[v]);
    }
  }
  EXPECT_GT(whole, shares.size() / 2);
}

TEST(Retreat, LeavesValidMovesAlone) {
  const Mesh before = two_balls();
  Mesh mesh = before;
  for (Vec3f& p : mesh.positions) p *= 2.0F;
  const Mesh scaled = mesh;
  const std::vector<float> shares = retreat(before.positions, mesh);
  EXPECT_EQ(std::count(shares.begin(), shares.end(), 1.0F), std::ssize(shares));
  EXPECT_EQ(mesh, scaled);
}

TEST(Retreat, TheSameBytesForAnyNumberOfThreads) {
  const Mesh before = two_balls();
  Mesh reference = collided();
  retreat(before.positions, reference);
  for (const int threads : {1, 2, 5, 8}) {
    Mesh mesh = collided();
    with_threads(threads, [&] { retreat(before.positions, mesh); });
    EXPECT_EQ(mesh, reference);
  }
}

TEST(Displacement, MeshesThatAlreadyIntersectThemselvesAreNotHeld) {
  const Mesh before = collided();
  Mesh mesh = before;
  for (Vec3f& p : mesh.positions) p.y += 0.3F;
  const Mesh moved = mesh;
  prevent_crossings(before.positions, mesh);
  EXPECT_EQ(mesh, moved);
}

TEST(Folds, AreTrianglesThatFaceAgainstTheSurface) {
  Mesh ball = sphere_mesh(Vec3d(0), 1, 3);
  EXPECT_TRUE(folded_triangles(ball).empty());
  EXPECT_TRUE(folded_triangles(box_mesh(Box3d(Vec3d(0), Vec3d(1, 1, 0.01)))).empty());
  std::swap(ball.triangles[200][0], ball.triangles[200][1]);
  const std::vector<uint32_t> folded = folded_triangles(ball);
  EXPECT_EQ(folded, std::vector<uint32_t>{200});
  const Fans fans(ball);
  for (uint32_t face = 0; face < ball.triangles.size(); ++face)
    EXPECT_EQ(is_folded(ball, fans, face), std::binary_search(folded.begin(), folded.end(), face));
}

}  // namespace
}  // namespace vug::mesh
