// SPDX-License-Identifier: Apache-2.0
// A clipped mesh has a boundary on the contour and no gap anywhere else.
#include <vug/base/error.h>
#include <vug/mesh/clip.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::mesh {
namespace {

constexpr float kLevel = 0.3F;

/// A ball with its height y, exactly linear, as the clip values and as an attribute.
Mesh ball() {
  Mesh mesh = sphere_mesh(Vec3d(0), 1, 4);
  mesh.normals = vertex_normals(mesh);
  mesh.attributes = {{"linear", 3, {}}};
  for (const Vec3f& p : mesh.positions)
    for (const float c : {p.x + 2 * p.y, p.z, p.y}) mesh.attributes[0].values.push_back(c);
  return mesh;
}

std::vector<float> heights(const Mesh& mesh, float sign = 1) {
  std::vector<float> values;
  for (const Vec3f& p : mesh.positions) values.push_back(sign * p.y);
  return values;
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (size_t face = 0; face < mesh.triangles.size(); ++face)
    sum += 0.5 * double_area_vector(mesh, face).length();
  return sum;
}

TEST(Clip, TheBoundaryIsOneLineOnTheContour) {
  const Mesh whole = ball();
  const Mesh below = clip(whole, heights(whole), kLevel);
  const Topology topology = inspect(below);
  EXPECT_EQ(topology.boundary_loops, 1u) << "only the rim is open";
  EXPECT_EQ(topology.nonmanifold_edges + topology.misoriented_edges, 0u);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.unused_vertices + topology.degenerate_triangles, 0u);
  size_t on_rim = 0;
  for (const Vec3f& p : below.positions) {
    EXPECT_LE(p.y, kLevel + 1e-6F);
    on_rim += std::fabs(p.y - kLevel) < 1e-6F;
  }
  EXPECT_EQ(on_rim, topology.boundary_edges);
}

TEST(Clip, BothSidesAddUpToTheWhole) {
  const Mesh whole = ball();
  const Mesh below = clip(whole, heights(whole), kLevel);
  const Mesh above = clip(whole, heights(whole, -1), -kLevel);
  EXPECT_NEAR(area(below) + area(above), area(whole), 1e-5 * area(whole));
  // A spherical zone of radius 1 has the area 2 pi times its height.
  EXPECT_NEAR(area(above), 2 * kPi * (1 - static_cast<double>(kLevel)), 0.02);
}

TEST(Clip, VertexAttributesAreInterpolated) {
  const Mesh whole = ball();
  const Mesh below = clip(whole, heights(whole), kLevel);
  ASSERT_EQ(below.normals.size(), below.positions.size());
  for (size_t v = 0; v < below.positions.size(); ++v) {
    const Vec3f& p = below.positions[v];
    const float* values = &below.attributes[0].values[3 * v];
    EXPECT_NEAR(values[0], p.x + 2 * p.y, 1e-6F);
    EXPECT_NEAR(values[1], p.z, 1e-6F);
    EXPECT_NEAR(below.normals[v].length(), 1, 1e-6F);
    EXPECT_GT(below.normals[v].dot(p), 0.99F);
  }
}

TEST(Clip, KeepsOrRemovesWholeMeshes) {
  const Mesh whole = ball();
  EXPECT_EQ(clip(whole, heights(whole), 2), whole);
  const Mesh none = clip(whole, heights(whole), -2);
  EXPECT_TRUE(none.positions.empty() && none.triangles.empty() && none.normals.empty());
  EXPECT_EQ(none.attributes.size(), 1u);
  EXPECT_THROW(clip(whole, {1, 2, 3}, 0), Error);
}

// Where the contour runs through vertices or along edges, only the part beyond it is removed.
TEST(Clip, AContourThroughVertices) {
  Mesh square;
  square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};
  const Mesh along = clip(square, {0, 0.5F, 0.5F, 0, 1}, 0.5F);
  EXPECT_EQ(along.triangles.size(), 2u);
  EXPECT_EQ(along.positions.size(), 4u);
  const Mesh near = clip(square, {0, 0.4999F, 0.4999F, 0, 1}, 0.5F);
  EXPECT_EQ(near, along) << "too near to be worth a sliver";
  const Mesh corner = clip(square, {0, 1, 0, 0, 1}, 0);
  EXPECT_EQ(corner.triangles, (std::vector<Triangle>{{0, 1, 2}})) << "the one without 1";
  EXPECT_EQ(corner.positions.size(), 3u);
}

}  // namespace
}  // namespace vug::mesh
