// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/vec.h>
#include <vug/mesh/polygon.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace vug::mesh {
namespace {

/// Appends a ring of corners around a centre, in an inclined plane, to the mesh.
std::vector<uint32_t> ring(Mesh& mesh, double x, double y, double radius, int corners, bool star) {
  std::vector<uint32_t> out;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * i / corners;
    const double r = star && i % 2 == 1 ? radius / 2 : radius;
    const double u = x + r * maths::cos(angle), v = y + r * maths::sin(angle);
    out.push_back(static_cast<uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(Vec3f(Vec3d(u, 0.6 * v, 0.8 * v)));
  }
  return out;
}

/// Area towards (0, -0.8, 0.6), the normal of the plane.
double tilted_area(const Mesh& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.triangles.size(); ++i)
    sum += 0.5 * double_area_vector(mesh, i).dot(Vec3d(0, -0.8, 0.6));
  return sum;
}

double disc(double radius, int corners, bool star = false) {
  const double triangle = 0.5 * radius * radius * std::sin(2 * kPi / corners);
  return corners * triangle * (star ? 0.5 : 1);
}

TEST(Polygon, RingsLeaveHolesOutAndIslandsIn) {
  Mesh mesh;
  const auto outer = ring(mesh, 0, 0, 1, 40, true);
  auto hole = ring(mesh, 0.1, 0, 0.3, 30, false);
  const auto island = ring(mesh, 0.1, 0.05, 0.1, 5, false);
  const auto second = ring(mesh, -0.35, 0.1, 0.1, 7, false);
  add_rings(mesh, {outer, hole, island, second});
  const double expected = disc(1, 40, true) - disc(0.3, 30) + disc(0.1, 5) - disc(0.1, 7);
  EXPECT_NEAR(tilted_area(mesh), expected, 1e-6);
  const Topology t = inspect(mesh);
  EXPECT_EQ(t.boundary_loops, 4u);
  EXPECT_EQ(t.components, 2u);
  EXPECT_EQ(t.misoriented_edges, 0u);
  // Holes may have either orientation.
  mesh.triangles.clear();
  std::reverse(hole.begin(), hole.end());
  add_rings(mesh, {outer, hole, island, second});
  EXPECT_NEAR(tilted_area(mesh), expected, 1e-6);
}

TEST(Polygon, KeepsConcavitiesForAnyNumberOfCorners) {
  for (const int corners : {10, 64, 66, 2000}) {
    Mesh mesh;
    const auto star = ring(mesh, 0.2, 0.3, 1, corners, true);
    add_polygon(mesh, star);
    EXPECT_EQ(mesh.triangles.size(), star.size() - 2);
    EXPECT_NEAR(tilted_area(mesh), disc(1, corners, true), 1e-5) << corners;
  }
}

TEST(Polygon, SelfIntersectionIsFannedOrRefused) {
  Mesh mesh;
  std::vector<uint32_t> tangle = ring(mesh, 0, 0, 1, 80, false);
  std::swap(tangle[5], tangle[40]);
  add_polygon(mesh, tangle);
  EXPECT_EQ(mesh.triangles.size(), 78u);
  mesh.triangles.clear();
  EXPECT_THROW(add_rings(mesh, {tangle}), Error);
  EXPECT_TRUE(mesh.triangles.empty());
  const std::vector<uint32_t> thread = {tangle[0], tangle[1], tangle[0]};
  add_rings(mesh, {thread});
  EXPECT_TRUE(mesh.triangles.empty());
}

}  // namespace
}  // namespace vug::mesh
