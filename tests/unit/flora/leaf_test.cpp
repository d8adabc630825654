// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/leaf.h>

#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/flora/merge_instances.h>
#include <vug/mesh/topology.h>

#include <cmath>

namespace vug::flora {
namespace {

/// Area of the mesh in square metres.
double area(const mesh::Mesh& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.triangles.size(); ++i)
    sum += mesh::double_area_vector(mesh, i).length() / 2;
  return sum;
}

TEST(Leaf, FlatLeafHasItsLengthWidthAndArea) {
  LeafOptions o;
  o.length = 0.2, o.width = 0.03, o.bend = 0, o.fold = 0, o.rows = 400;
  const mesh::Mesh flat = leaf(o);
  const Box3d box = mesh::bounds(flat);
  EXPECT_NEAR(box.max.y, 0.2, 1e-6);
  EXPECT_NEAR(box.size().x, 0.03, 1e-5);
  EXPECT_EQ(box.size().z, 0);
  // Integral of the outline by the midpoint rule.
  double expected = 0;
  for (int i = 0; i < 4000; ++i) {
    const double t = (i + 0.5) / 4000;
    expected += std::max(o.outline.half_width(t), t < o.outline.widest ? 0.07 : 0) / 4000;
  }
  EXPECT_NEAR(area(flat) / (expected * 0.2 * 0.03), 1, 1e-3);
  for (const Vec3f& normal : flat.normals) EXPECT_EQ(normal, Vec3f(0, 0, 1));
}

TEST(Leaf, MidribKeepsItsLengthAndBendsDown) {
  LeafOptions o;
  o.bend = 1.2, o.rows = 200;
  const mesh::Mesh bent = leaf(o);
  const mesh::Attribute& across = *mesh::find_attribute(bent, paint::kLeafAcross);
  std::vector<Vec3d> rib;
  for (size_t i = 0; i < bent.positions.size(); ++i)
    if (across.values[i] == 0) rib.emplace_back(bent.positions[i]);
  ASSERT_EQ(rib.size(), 201u);
  double length = 0;
  for (size_t i = 1; i < rib.size(); ++i) length += (rib[i] - rib[i - 1]).length();
  EXPECT_NEAR(length, o.length, 1e-5);
  const Vec3d end = (rib[200] - rib[199]).normalized(), begin = (rib[1] - rib[0]).normalized();
  EXPECT_NEAR(std::acos(begin.dot(end)), 1.2, 0.02);
  EXPECT_LT(end.z, 0);
}

TEST(Leaf, HalvesRiseFromTheMidrib) {
  LeafOptions o;
  o.bend = 0, o.fold = 0.4;
  const mesh::Mesh folded = leaf(o);
  // Rows of left, middle and right vertices.
  for (uint32_t row = 0; row + 3 < folded.positions.size(); row += 3) {
    const Vec3f left = folded.positions[row] - folded.positions[row + 1];
    const Vec3f right = folded.positions[row + 2] - folded.positions[row + 1];
    EXPECT_NEAR(std::atan2(right.z, right.x), 0.4, 1e-4);
    EXPECT_NEAR(left.z, right.z, 1e-9);
    EXPECT_NEAR(left.x, -right.x, 1e-9);
  }
}

TEST(Leaf, IsOneUpwardFacingSheetWithoutHoles) {
  for (const bool card : {false, true}) {
    LeafOptions o;
    o.card = card, o.twist = 0.5;
    const mesh::Mesh blade = leaf(o);
    const mesh::Topology found = mesh::inspect(blade);
    EXPECT_EQ(found.nonmanifold_edges, 0u);
    EXPECT_EQ(found.misoriented_edges, 0u);
    EXPECT_EQ(found.unused_vertices, 0u);
    EXPECT_GT(mesh::double_area_vector(blade, 0).z, 0);
    EXPECT_EQ(mesh::find_attribute(blade, paint::kLeafAcross)->values.front() == -1, card);
  }
  LeafOptions none;
  none.width = 0;
  EXPECT_THROW(leaf(none), Error);
  none = LeafOptions();
  none.rows = 1;
  EXPECT_THROW(leaf(none), Error);
}

TEST(Leaf, OutlineIsWidestAsSpecifiedAndVeinsFollowIt) {
  const paint::LeafOutline outline{0.35, 1.3};
  EXPECT_NEAR(outline.half_width(0.35), 1, 1e-12);
  for (const double t : {0.01, 0.2, 0.34, 0.36, 0.7, 0.99}) EXPECT_LT(outline.half_width(t), 1);
  EXPECT_TRUE(outline.contains({0.9, 0.35}));
  EXPECT_FALSE(outline.contains({0.9, 0.9}));
  const paint::LeafVeins veins{5, 0.06, 0};
  EXPECT_EQ(paint::vein_at({0, 0.5}, outline, veins), 1);
  // The second vein: two lanes of five and a half, at any position.
  for (const double t : {0.2, 0.5, 0.8})
    EXPECT_NEAR(paint::vein_at({outline.half_width(t) * 2 / 5.5, t}, outline, veins), 0.5, 1e-9);
  EXPECT_EQ(paint::vein_at({outline.half_width(0.5) * 2.5 / 5.5, 0.5}, outline, veins), 0);
}

TEST(Spray, HasLeavesOnBothSidesAndDependsOnItsKey) {
  SprayOptions o;
  o.leaves = 5, o.key = RandomKey(4);
  const mesh::Mesh twig = spray(o), one = leaf(o.leaf);
  EXPECT_EQ(twig.triangles.size(), 5 * one.triangles.size());
  const Box3d box = mesh::bounds(twig);
  EXPECT_LT(box.min.x, -0.03);
  EXPECT_GT(box.max.x, 0.03);
  EXPECT_GT(box.max.y, 4 * o.spacing + 0.8 * 0.6 * o.leaf.length);
  EXPECT_EQ(twig, spray(o));
  o.key = RandomKey(5);
  EXPECT_NE(twig, spray(o));
}

}  // namespace
}  // namespace vug::flora
