// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/normals.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/topology.h>
#include <vug/mesh/weld.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::mesh {
namespace {

const Box3d kUnitBox(Vec3d(0), Vec3d(1));

double volume(const Mesh& mesh) {
  double sum = 0;
  for (size_t face = 0; face < mesh.triangles.size(); ++face)
    sum += corners(mesh, face)[0].dot(double_area_vector(mesh, face)) / 6;
  return sum;
}

TEST(Shapes, AreClosedOutwardAndOfTheirGenus) {
  const struct {
    Mesh mesh;
    size_t genus;
  } cases[] = {
      {box_mesh(kUnitBox), 0}, {sphere_mesh({1, 2, 3}, 2, 3), 0}, {torus_mesh(2, 0.5, 24, 12), 1}};
  for (const auto& c : cases) {
    const Topology topology = inspect(c.mesh);
    EXPECT_TRUE(topology.closed());
    EXPECT_EQ(topology.misoriented_edges, 0U);
    EXPECT_EQ(topology.nonmanifold_vertices, 0U);
    EXPECT_EQ(topology.degenerate_triangles, 0U);
    EXPECT_EQ(topology.components, 1U);
    EXPECT_EQ(topology.genus, c.genus);
    EXPECT_EQ(2 * topology.edges, 3 * c.mesh.triangles.size());
    EXPECT_GT(volume(c.mesh), 0);
  }
}

TEST(Topology, DetectsAHole) {
  Mesh mesh = torus_mesh(2, 0.5, 24, 12);
  mesh.triangles.erase(mesh.triangles.begin() + 20);
  const Topology topology = inspect(mesh);
  EXPECT_EQ(topology.boundary_edges, 3U);
  EXPECT_EQ(topology.boundary_loops, 1U);
  EXPECT_EQ(topology.genus, 1U);
  EXPECT_FALSE(topology.closed());
}

TEST(Topology, DetectsAFlippedTriangle) {
  Mesh mesh = box_mesh(kUnitBox);
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  const Topology topology = inspect(mesh);
  EXPECT_EQ(topology.misoriented_edges, 3U);
  EXPECT_FALSE(topology.genus.has_value());
}

TEST(Topology, BoxesThatTouchInAPointShareAVertexButNoComponent) {
  const Mesh mesh = welded(joined(box_mesh(kUnitBox), box_mesh({Vec3d(1), Vec3d(2)})));
  EXPECT_EQ(mesh.positions.size(), 15U);
  const Topology topology = inspect(mesh);
  EXPECT_EQ(topology.nonmanifold_vertices, 1U);
  EXPECT_EQ(topology.components, 2U);
  EXPECT_EQ(topology.genus, 0U);
}

TEST(Topology, BoxesThatTouchInAnEdgeAreNotManifold) {
  const Mesh mesh = welded(joined(box_mesh(kUnitBox), box_mesh({Vec3d(1, 1, 0), Vec3d(2, 2, 1)})));
  const Topology topology = inspect(mesh);
  EXPECT_EQ(topology.nonmanifold_edges, 1U);
  EXPECT_FALSE(topology.genus.has_value());
}

TEST(Topology, CountsComponentsAndUnusedVertices) {
  Mesh mesh = joined(torus_mesh(2, 0.5, 12, 8), sphere_mesh({9, 0, 0}, 1, 1));
  mesh.positions.emplace_back(5, 5, 5);
  const Topology topology = inspect(mesh);
  EXPECT_EQ(topology.components, 2U);
  EXPECT_EQ(topology.genus, 1U);
  EXPECT_EQ(topology.unused_vertices, 1U);
  EXPECT_EQ(without_unused_vertices(mesh).positions.size(), mesh.positions.size() - 1);
}

TEST(Weld, RestoresATriangleSoup) {
  const Mesh whole = sphere_mesh(Vec3d(0), 1, 3);
  Mesh soup;
  for (const Triangle& t : whole.triangles)
    for (const uint32_t corner : t) {
      soup.positions.push_back(whole.positions[corner]);
      if (soup.positions.size() % 3 == 0) {
        const auto n = static_cast<uint32_t>(soup.positions.size());
        soup.triangles.push_back({n - 3, n - 2, n - 1});
      }
    }
  const Mesh again = welded(soup);
  EXPECT_EQ(again.positions.size(), whole.positions.size());
  EXPECT_TRUE(inspect(again).closed());
  EXPECT_EQ(inspect(again).genus, 0U);
}

TEST(Normals, OfABoxCornerPointAlongTheDiagonalHoweverItIsCut) {
  const Mesh mesh = box_mesh({Vec3d(-1), Vec3d(1)});
  const std::vector<Vec3f> normals = vertex_normals(mesh);
  for (size_t i = 0; i < normals.size(); ++i)
    EXPECT_NEAR(normals[i].dot(mesh.positions[i].normalized()), 1, 1e-6);
}

TEST(Normals, OfASpherePointOutwards) {
  const Mesh mesh = sphere_mesh(Vec3d(0), 3, 4);
  const std::vector<Vec3f> normals = vertex_normals(mesh);
  for (size_t i = 0; i < normals.size(); ++i)
    EXPECT_GT(normals[i].dot(mesh.positions[i].normalized()), 0.9999);
}

}  // namespace
}  // namespace vug::mesh
