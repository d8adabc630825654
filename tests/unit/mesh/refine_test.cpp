// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/mesh/refine.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

double longest_edge(const Mesh& mesh) {
  double longest = 0;
  for (const Triangle& t : mesh.triangles)
    for (size_t k = 0; k < 3; ++k)
      longest = std::max(
          longest,
          static_cast<double>((mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).length()));
  return longest;
}

double volume_of(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += Vec3d(mesh.positions[t[0]])
               .dot(Vec3d(mesh.positions[t[1]]).cross(Vec3d(mesh.positions[t[2]]))) /
           6;
  return sum;
}

// The edges of a long box differ, so there are triangles with one, two and three long edges.
TEST(Refine, KeepsTheSurfaceClosedAndInPlace) {
  Mesh box = box_mesh(Box3d(Vec3d(0), Vec3d(4, 1, 0.3)));
  Attribute x{"x", 1, {}}, place{"place", 3, {}};
  for (const Vec3f& p : box.positions) {
    x.values.push_back(p.x);
    for (int c = 0; c < 3; ++c) place.values.push_back(2 * p[c]);
  }
  box.attributes = {x, place};
  const Mesh fine = refined(box, 0.2);
  EXPECT_LE(longest_edge(fine), 0.2);
  const Topology topology = inspect(fine);
  EXPECT_EQ(topology.boundary_edges, 0u);
  EXPECT_EQ(topology.nonmanifold_edges, 0u);
  EXPECT_EQ(topology.misoriented_edges, 0u);
  EXPECT_NEAR(volume_of(fine), 1.2, 1e-6);
  // Less than ten times the number of triangles with three edges of this length.
  EXPECT_LT(fine.triangles.size(), 10 * 2 * (4 * 1 + 4 * 0.3 + 1 * 0.3) / (0.433 * 0.2 * 0.2));
  for (size_t v = 0; v < fine.positions.size(); ++v) {
    EXPECT_NEAR(fine.attributes[0].values[v], fine.positions[v].x, 1e-6f);
    EXPECT_NEAR(fine.attributes[1].values[3 * v + 1], 2 * fine.positions[v].y, 1e-6f);
  }
  for (size_t v = 0; v < box.positions.size(); ++v) EXPECT_EQ(fine.positions[v], box.positions[v]);
}

TEST(Refine, NormalsStayOfUnitLength) {
  Mesh ball = sphere_mesh(Vec3d(0), 1, 1);
  ball.normals = ball.positions;
  const Mesh fine = refined(ball, 0.1);
  for (size_t v = 0; v < fine.positions.size(); ++v) {
    EXPECT_NEAR(fine.normals[v].length(), 1, 1e-6f);
    EXPECT_GT(fine.normals[v].dot(fine.positions[v].normalized()), 0.99f);
  }
}

TEST(Refine, LeavesFineMeshesAlone) {
  const Mesh ball = sphere_mesh(Vec3d(0), 1, 3);
  const Mesh same = refined(ball, 1);
  EXPECT_EQ(same.positions, ball.positions);
  EXPECT_EQ(same.triangles, ball.triangles);
}

TEST(Refine, RefusesTooManyTriangles) {
  EXPECT_THROW(refined(sphere_mesh(Vec3d(0), 1, 1), 0.01, 1000), Error);
  EXPECT_THROW(refined(sphere_mesh(Vec3d(0), 1, 1), 0), Error);
}

}  // namespace
}  // namespace vug::mesh
