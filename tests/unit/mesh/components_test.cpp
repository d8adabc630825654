// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/components.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace vug::mesh {
namespace {

/// With normals and two attributes that distinguish the vertices of different `mark`.
Mesh marked_ball(const Vec3d& centre, double radius, float mark) {
  Mesh mesh = sphere_mesh(centre, radius, 2);
  mesh.normals = vertex_normals(mesh);
  mesh.attributes = {{"Cd", 3, {}}, {"mark", 1, {}}};
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const float part : {0.25F, 0.5F, 0.75F})
      mesh.attributes[0].values.push_back(mark + part + static_cast<float>(v));
    mesh.attributes[1].values.push_back(mark);
  }
  return mesh;
}

Mesh inside_out(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  return mesh;
}

TEST(Components, TheSmallerOfTwoIsRemovedCompletely) {
  const Mesh large = marked_ball({0, 0, 0}, 1, 1000);
  const Mesh small = marked_ball({3, 0, 0}, 0.1, 2000);
  for (const Mesh& both : {joined(large, small), joined(small, large)}) {
    const LargeComponents left = large_components(both, 1);
    EXPECT_EQ(left.removed, 1U);
    EXPECT_EQ(left.mesh, large) << "order, normals and attributes";
  }
}

// The vertices of a sphere mesh lie on the sphere, and its first twelve span the bounding box of an
// icosahedron; the diagonal is close to that of the cube around the ball.
TEST(Components, TheSizeIsTheDiagonalOfTheBox) {
  const Mesh small = marked_ball({3, 0, 0}, 0.1, 2000);
  const Mesh both = joined(marked_ball({0, 0, 0}, 1, 1000), small);
  const double diagonal = bounds(small).size().length();
  EXPECT_NEAR(diagonal, 0.2 * std::sqrt(3), 0.01);
  EXPECT_EQ(large_components(both, 0.999 * diagonal).mesh, both);
  EXPECT_EQ(large_components(both, 0.999 * diagonal).removed, 0U);
  EXPECT_EQ(large_components(both, 1.001 * diagonal).removed, 1U);
}

TEST(Components, ABubbleInsideABallIsRemovedToo) {
  const Mesh large = marked_ball({0, 0, 0}, 1, 1000);
  const Mesh bubble = inside_out(marked_ball({0.2, 0, 0}, 0.1, 2000));
  const LargeComponents left = large_components(joined(large, bubble), 1);
  EXPECT_EQ(left.removed, 1U);
  EXPECT_EQ(left.mesh, large);
}

TEST(Components, TheLargestStaysWhateverItsSize) {
  const Mesh large = marked_ball({0, 0, 0}, 0.2, 1000);
  const Mesh three =
      joined(joined(marked_ball({3, 0, 0}, 0.1, 2000), large), marked_ball({5, 0, 0}, 0.15, 3000));
  const LargeComponents left = large_components(three, 100);
  EXPECT_EQ(left.removed, 2U);
  EXPECT_EQ(left.mesh, large);
}

TEST(Components, TouchingInAPointIsNotConnected) {
  Mesh both = joined(box_mesh({Vec3d(0), Vec3d(1)}), box_mesh({Vec3d(1), Vec3d(1.1)}));
  const LargeComponents left = large_components(both, 1);
  EXPECT_EQ(left.removed, 1U);
  EXPECT_EQ(left.mesh, box_mesh({Vec3d(0), Vec3d(1)}));
}

TEST(Components, ZeroKeepsEverything) {
  Mesh both = joined(marked_ball({0, 0, 0}, 1, 1000), marked_ball({3, 0, 0}, 1e-6, 2000));
  for (Attribute& attribute : both.attributes)  // For a vertex that no triangle uses.
    attribute.values.resize(attribute.values.size() + static_cast<size_t>(attribute.arity));
  both.positions.emplace_back(9.0F);
  both.normals.emplace_back(0.0F, 1.0F, 0.0F);
  const LargeComponents left = large_components(both, 0);
  EXPECT_EQ(left.removed, 0U);
  EXPECT_EQ(left.mesh, both);
}

TEST(Components, AnEmptyMeshStaysEmpty) {
  EXPECT_EQ(large_components({}, 1).mesh, Mesh());
  EXPECT_EQ(large_components({}, 1).removed, 0U);
}

}  // namespace
}  // namespace vug::mesh
