// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/mesh/flat_fans.h>
#include <vug/mesh/self_intersections.h>
#include <vug/mesh/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace vug::mesh {
namespace {

TEST(SelfIntersections, NoneInProperMeshes) {
  EXPECT_TRUE(self_intersections(box_mesh(Box3d(Vec3d(0), Vec3d(1)))).empty());
  EXPECT_TRUE(self_intersections(torus_mesh(2, 0.7, 60, 30)).empty());
  EXPECT_TRUE(self_intersections(sphere_mesh(Vec3d(0), 1, 4)).empty());
}

TEST(SelfIntersections, AreFoundInATubeThatIsTooThickForItsRing) {
  EXPECT_FALSE(self_intersections(torus_mesh(1, 1.3, 60, 30)).empty());
}

TEST(SelfIntersections, WithinComponentsLeaveOutThoseThatPenetrateEachOther) {
  Mesh mesh = torus_mesh(1, 1.3, 60, 30);
  const std::vector<FacePair> own = self_intersections(mesh);
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  std::vector<uint32_t> component_of(mesh.triangles.size(), 0);
  const Mesh ball = sphere_mesh(Vec3d(1, 0, 0), 1, 3);
  mesh.positions.insert(mesh.positions.end(), ball.positions.begin(), ball.positions.end());
  for (const Triangle& t : ball.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  component_of.resize(mesh.triangles.size(), 1);
  EXPECT_GT(self_intersections(mesh).size(), own.size());
  EXPECT_EQ(self_intersections(mesh, component_of), own);
}

TEST(SelfIntersections, FindPairsBySharedCorners) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0},         {1, 0, 0}, {0, 1, 0}, {0.25F, 0.25F, -1},
                    {0.25F, 0.25F, 1}, {3, 3, 1}, {1, 1, 0}, {0.2F, 0.2F, 0}};
  const auto pairs = [&](std::vector<Triangle> triangles) {
    mesh.triangles = std::move(triangles);
    return self_intersections(mesh).size();
  };
  EXPECT_EQ(pairs({{0, 1, 2}, {3, 4, 5}}), 1U) << "apart, one pierces the other";
  EXPECT_EQ(pairs({{0, 1, 2}, {0, 3, 4}}), 1U) << "one shared corner, pierced";
  EXPECT_EQ(pairs({{0, 1, 2}, {1, 6, 5}}), 0U) << "one shared corner, only that";
  EXPECT_EQ(pairs({{0, 1, 2}, {2, 1, 6}}), 0U) << "unfolded neighbours";
  EXPECT_EQ(pairs({{0, 1, 2}, {2, 1, 7}}), 1U) << "folded flat onto its neighbour";
  EXPECT_EQ(pairs({{0, 1, 2}, {2, 1, 4}}), 0U) << "a sharp but honest edge";
}

/// A torus whose vertices moved at random by up to `amount`.
Mesh crumpled(double amount) {
  Mesh mesh = torus_mesh(2, 0.7, 40, 20);
  RandomStream random(RandomKey(7));
  for (Vec3f& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis)
      p[axis] += static_cast<float>(amount * (2 * random.uniform() - 1));
  return mesh;
}

TEST(FlatFans, AreNeverWhereNeighboursIntersect) {
  for (const double amount : {0.0, 0.02, 0.2, 0.4}) {
    const Mesh mesh = crumpled(amount);
    const std::vector<char> flat = flat_fans(mesh);
    // Without the fans, every pair is tested.
    std::vector<uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    const auto pairs = self_intersections_of(all, mesh, BoxTree(triangle_boxes(mesh)));
    EXPECT_EQ(self_intersections(mesh), pairs) << amount;
    EXPECT_EQ(pairs.empty(), amount <= 0.02) << amount;
    const auto count = std::count(flat.begin(), flat.end(), 1);
    if (amount <= 0.02)
      EXPECT_EQ(count, std::ssize(flat)) << amount;
    else
      EXPECT_LT(count, std::ssize(flat)) << amount;
  }
}

TEST(FlatFans, BoundariesAreNot) {
  Mesh mesh = box_mesh(Box3d(Vec3d(0), Vec3d(1)));
  mesh.triangles.pop_back();
  const std::vector<char> flat = flat_fans(mesh);
  EXPECT_LT(std::count(flat.begin(), flat.end(), 1), 6);
}

TEST(SelfIntersections, OfSomeFacesAreThePairsThatContainThem) {
  const Mesh mesh = crumpled(0.3);
  const BoxTree tree(triangle_boxes(mesh));
  std::vector<uint32_t> faces;
  for (uint32_t f = 0; f < mesh.triangles.size(); f += 7) faces.push_back(f);
  std::vector<FacePair> expected;
  for (const FacePair& pair : self_intersections(mesh))
    if (pair.first % 7 == 0 || pair.second % 7 == 0) expected.push_back(pair);
  ASSERT_FALSE(expected.empty());
  for (const int threads : {1, 2, 5, 8})
    with_threads(threads, [&] { EXPECT_EQ(self_intersections_of(faces, mesh, tree), expected); });
}

}  // namespace
}  // namespace vug::mesh
