// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/levels.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include "sample.h"

namespace vug::exchange {
namespace {

mesh::Mesh ball(int levels) {
  mesh::Mesh mesh = mesh::sphere_mesh({1, 2, 3}, 1, levels);
  mesh.normals = mesh::vertex_normals(mesh);
  mesh::Attribute height{"height", 1, {}};
  for (const Vec3f& p : mesh.positions) height.values.push_back(p.y);
  mesh.attributes.push_back(std::move(height));
  return mesh;
}

TEST(Levels, SimplifiedMeshesKeepTheirAttributes) {
  const mesh::Mesh fine = ball(5);
  const mesh::Mesh coarse = coarser(fine);
  EXPECT_NO_THROW(mesh::validate(coarse, "t"));
  EXPECT_NEAR(static_cast<double>(coarse.triangles.size()),
              0.25 * static_cast<double>(fine.triangles.size()), 8);
  const mesh::Topology topology = mesh::inspect(coarse);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.unused_vertices, 0u);
  for (size_t v = 0; v < coarse.positions.size(); ++v)
    EXPECT_EQ(coarse.attributes.at(0).values[v], coarse.positions[v].y);
  EXPECT_EQ(coarse.normals.size(), coarse.positions.size());
}

TEST(Levels, DistancesOfKnownSurfaces) {
  const mesh::Mesh small = mesh::box_mesh(Box3d(Vec3d(0.0), Vec3d(1.0)));
  const mesh::Mesh moved = mesh::box_mesh(Box3d(Vec3d(0.25, 0, 0), Vec3d(1.25, 1, 1)));
  const mesh::Mesh large = mesh::box_mesh(Box3d(Vec3d(-1.0), Vec3d(2.0)));
  EXPECT_NEAR(hausdorff_distance(small, small), 0, 1e-12);
  EXPECT_NEAR(hausdorff_distance(small, moved), 0.25, 1e-6);
  // From a corner of the large cube to that of the small one, in either order of arguments.
  EXPECT_NEAR(hausdorff_distance(small, large), std::sqrt(3.0), 1e-6);
  EXPECT_NEAR(hausdorff_distance(large, small), std::sqrt(3.0), 1e-6);
  // A ball with n subdivisions lies inside the sphere by about h^2 / 8.
  const double off = hausdorff_distance(ball(3), ball(6));
  EXPECT_GT(off, 1e-3);
  EXPECT_LT(off, 1e-2);
}

TEST(Levels, HaveFewerTrianglesAndTheirDistance) {
  Assembly all = sample();
  all.prototypes[0].mesh = std::make_shared<const mesh::Mesh>(ball(5));
  add_levels(all, 3);
  const std::vector<Level>& levels = all.prototypes[0].coarser;
  ASSERT_EQ(levels.size(), 3u);
  double last = 0;
  for (const Level& level : levels) {
    EXPECT_EQ(level.distance, hausdorff_distance(*all.prototypes[0].mesh, *level.mesh));
    EXPECT_GT(level.distance, last);
    last = level.distance;
  }
  // 320 triangles for a ball of 1 m: edges of about a quarter of a metre.
  EXPECT_LT(last, 0.05);
  EXPECT_EQ(at_level(all, 2).prototypes[0].mesh, levels[1].mesh);
  EXPECT_EQ(at_level(all, 9).prototypes[0].mesh, levels[2].mesh);
  EXPECT_EQ(at_level(sample(), 1).prototypes[0].mesh->triangles.size(), 12u);
}

TEST(Levels, StopAtTheSmallestSolid) {
  Assembly all = sample();
  all.prototypes[0].mesh = std::make_shared<const mesh::Mesh>(ball(3));
  add_levels(all, 8);
  const std::vector<Level>& levels = all.prototypes[0].coarser;
  ASSERT_GE(levels.size(), 2u);
  EXPECT_LT(levels.size(), 5u);  // of 512 triangles
  size_t before = all.prototypes[0].mesh->triangles.size();
  for (const Level& level : levels) {
    EXPECT_GE(level.mesh->triangles.size(), 4u);
    EXPECT_LE(4 * level.mesh->triangles.size(), 3 * before);
    before = level.mesh->triangles.size();
  }
}

TEST(Levels, MeshesThatCannotBeSimplifiedStay) {
  Assembly all = sample();
  all.prototypes[0].mesh = std::make_shared<const mesh::Mesh>();
  add_levels(all, 2);
  EXPECT_TRUE(all.prototypes[0].coarser.empty());
}

}  // namespace
}  // namespace vug::exchange
