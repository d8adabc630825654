// SPDX-License-Identifier: Apache-2.0
// Simplified meshes keep their borders, their topology and their vertices' attributes, and stay
// near the surface.
#include <vug/mesh/hausdorff.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/simplify.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vug::mesh {
namespace {

using Point = std::array<float, 3>;
using PointEdge = std::pair<Point, Point>;

Point point_of(const Mesh& mesh, uint32_t v) {
  const Vec3f& p = mesh.positions[v];
  return {p.x, p.y, p.z};
}

/// The directed edges of the border, by the bits of their positions.
std::set<PointEdge> border_of(const Mesh& mesh) {
  std::map<PointEdge, int> uses;
  for (const Triangle& t : mesh.triangles)
    for (size_t k = 0; k < 3; ++k) ++uses[{point_of(mesh, t[k]), point_of(mesh, t[(k + 1) % 3])}];
  std::set<PointEdge> out;
  for (const auto& [edge, count] : uses)
    if (uses.count({edge.second, edge.first}) == 0) out.insert(edge);
  return out;
}

Mesh simplified_to(const Mesh& mesh, size_t triangles) {
  Simplifier simplifier(mesh);
  simplifier.reduce_to(triangles);
  return simplifier.mesh();
}

/// The triangles of a mesh on one side of a plane through the origin.
Mesh part_of(const Mesh& mesh, const Vec3d& axis) {
  Mesh out = mesh;
  out.triangles.clear();
  for (size_t face = 0; face < mesh.triangles.size(); ++face) {
    const auto [a, b, c] = corners(mesh, face);
    if ((a + b + c).dot(axis) > 0) out.triangles.push_back(mesh.triangles[face]);
  }
  return out;
}

TEST(Simplify, ClosedSurfacesKeepTheirTopology) {
  for (const Mesh& mesh : {sphere_mesh({1, 2, 3}, 1, 5), torus_mesh(1, 0.3, 90, 40),
                           joined(sphere_mesh({0, 0, 0}, 0.2, 4), torus_mesh(1, 0.1, 90, 12))}) {
    const Topology before = inspect(mesh);
    for (const size_t divisor : {4u, 16u, 64u, 1000000u}) {
      const Mesh coarse = simplified_to(mesh, mesh.triangles.size() / divisor);
      EXPECT_LE(coarse.triangles.size(), std::max<size_t>(mesh.triangles.size() / divisor, 200));
      const Topology after = inspect(coarse);
      EXPECT_TRUE(after.closed()) << divisor;
      EXPECT_EQ(after.misoriented_edges, 0u);
      EXPECT_EQ(after.nonmanifold_vertices, 0u);
      EXPECT_EQ(after.degenerate_triangles, 0u);
      EXPECT_EQ(after.unused_vertices, 0u);
      EXPECT_EQ(after.components, before.components);
      EXPECT_EQ(after.genus, before.genus);
    }
  }
}

TEST(Simplify, VerticesKeepTheirAttributes) {
  Mesh mesh = sphere_mesh({1, 2, 3}, 1, 5);
  mesh.normals = vertex_normals(mesh);
  Attribute height{"height", 1, {}};
  for (const Vec3f& p : mesh.positions) height.values.push_back(p.y);
  mesh.attributes.push_back(std::move(height));
  const Mesh coarse = simplified_to(mesh, mesh.triangles.size() / 20);
  EXPECT_NO_THROW(validate(coarse, "t"));
  for (size_t v = 0; v < coarse.positions.size(); ++v) {
    EXPECT_EQ(coarse.attributes.at(0).values[v], coarse.positions[v].y);
    const Vec3d outward = Vec3d(coarse.positions[v]) - Vec3d(1, 2, 3);
    EXPECT_GT(outward.dot(Vec3d(coarse.normals[v])), 0.99);
  }
}

TEST(Simplify, BordersStayBitForBit) {
  const Mesh whole = torus_mesh(1, 0.3, 120, 50);
  const Mesh half = part_of(whole, {0.3, 1, 0.2});
  const std::set<PointEdge> border = border_of(half);
  ASSERT_GT(border.size(), 100u);
  EXPECT_EQ(Simplifier(half).border_edges(), border.size());
  for (const size_t divisor : {4u, 10u, 1000000u}) {
    const Mesh coarse = simplified_to(half, half.triangles.size() / divisor);
    EXPECT_LT(coarse.triangles.size(), half.triangles.size() / 3);
    EXPECT_EQ(border_of(coarse), border) << divisor;
  }
}

// The extreme case: nothing but the borders remains, so that an edge across the border that both
// sides have would be found.
TEST(Simplify, PiecesThatAreSimplifiedSeparatelyStayClosed) {
  const Mesh whole = torus_mesh(1, 0.4, 60, 30);
  const Vec3d axis(1, 0.4, 0.2);
  const Mesh one = part_of(whole, axis), other = part_of(whole, -axis);
  ASSERT_EQ(one.triangles.size() + other.triangles.size(), whole.triangles.size());
  for (const size_t a : {1u, 8u, 1000000u})
    for (const size_t b : {1u, 8u, 1000000u}) {
      const Mesh left = simplified_to(one, one.triangles.size() / a);
      const Mesh right = simplified_to(other, other.triangles.size() / b);
      std::map<PointEdge, int> uses;
      for (const Mesh* part : {&left, &right})
        for (const Triangle& t : part->triangles)
          for (size_t k = 0; k < 3; ++k)
            ++uses[{point_of(*part, t[k]), point_of(*part, t[(k + 1) % 3])}];
      for (const auto& [edge, count] : uses) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(uses.count({edge.second, edge.first}), 1u);
      }
    }
}

TEST(Simplify, StepsDoNotChangeTheResult) {
  const Mesh mesh = part_of(torus_mesh(1, 0.3, 90, 40), {0, 1, 0});
  Simplifier steps(mesh);
  for (size_t wanted = mesh.triangles.size(); wanted > 400; wanted -= 100) steps.reduce_to(wanted);
  steps.reduce_to(400);
  EXPECT_EQ(steps.triangles(), steps.mesh().triangles.size());
  EXPECT_TRUE(steps.mesh() == simplified_to(mesh, 400));
}

TEST(Simplify, FlatRegionsLoseTheirTrianglesFirst) {
  // A cube of 12 * 32^2 triangles: its surface is that of 12.
  Mesh cube;
  std::map<Point, uint32_t> numbers;
  constexpr int kSteps = 32;
  const auto vertex = [&](const Vec3d& p) {
    const Vec3f at(p);
    const auto [known, fresh] = numbers.try_emplace({at.x, at.y, at.z}, cube.positions.size());
    if (fresh) cube.positions.push_back(at);
    return known->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1})
      for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
          const auto at = [&](int u, int v) {
            Vec3d p;
            p[axis] = side;
            p[(axis + 1) % 3] = static_cast<double>(u) / kSteps;
            p[(axis + 2) % 3] = static_cast<double>(v) / kSteps;
            return vertex(p);
          };
          const uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
          for (Triangle t : {Triangle{a, b, c}, Triangle{a, c, d}}) {
            if (side == 0) std::swap(t[1], t[2]);
            cube.triangles.push_back(t);
          }
        }
  ASSERT_TRUE(inspect(cube).closed());
  const Mesh coarse = simplified_to(cube, cube.triangles.size() / 16);
  EXPECT_LT(hausdorff_bound(cube, coarse), 0.01);
  size_t corners_left = 0;
  for (const Vec3f& p : coarse.positions)
    corners_left += (p.x == 0 || p.x == 1) && (p.y == 0 || p.y == 1) && (p.z == 0 || p.z == 1);
  EXPECT_EQ(corners_left, 8u);
}

TEST(Simplify, VerticesWhereFansTouchStay) {
  // Two balls that share one vertex.
  Mesh two = joined(sphere_mesh({0, 1, 0}, 1, 3), sphere_mesh({0, -1, 0}, 1, 3));
  const auto second = static_cast<uint32_t>(two.positions.size() / 2);
  for (Triangle& t : two.triangles)
    for (uint32_t& v : t)
      if (v == second) v = 0;
  const Point shared = point_of(two, 0);
  ASSERT_EQ(inspect(two).nonmanifold_vertices, 1u);
  const Mesh coarse = simplified_to(two, 0);
  EXPECT_LT(coarse.triangles.size(), 200u);
  EXPECT_EQ(inspect(coarse).nonmanifold_vertices, 1u);
  EXPECT_TRUE(inspect(coarse).closed());
  bool found = false;
  for (uint32_t v = 0; v < coarse.positions.size(); ++v) found |= point_of(coarse, v) == shared;
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace vug::mesh
