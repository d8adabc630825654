// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/merge_instances.h>

#include <gtest/gtest.h>
#include <vug/base/parallel.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/topology.h>

#include <set>

namespace vug::flora {
namespace {

mesh::Mesh block() {
  mesh::Mesh box = mesh::box_mesh(Box3d(Vec3d(0, 0, 0), Vec3d(1, 2, 3)));
  box.normals = mesh::vertex_normals(box);
  box.attributes.push_back({"height", 1, {}});
  for (const Vec3f& p : box.positions) box.attributes[0].values.push_back(p.y);
  return box;
}

TEST(MergeInstances, KeepsShapesAndAttributesAndNumbersInstances) {
  const Transform turned =
      Transform::translation({5, 0, 0}) * Transform::rotation({0, 1, 0}, kPi / 2);
  const Transform mirrored = Transform::translation({-5, 0, 0}) * Transform::scaling({1, 2, -1});
  const mesh::Mesh all =
      merge_instances({block()}, {{0, turned, RandomKey(1)}, {0, mirrored, RandomKey(2)}});
  const mesh::Topology found = mesh::inspect(all);
  EXPECT_EQ(found.components, 2u);
  EXPECT_EQ(found.boundary_edges + found.misoriented_edges, 0u);
  double volume = 0;
  for (size_t i = 0; i < all.triangles.size(); ++i) {
    const auto [a, b, c] = mesh::corners(all, i);
    volume += a.dot(b.cross(c)) / 6;
  }
  EXPECT_NEAR(volume, 6 + 12, 1e-5);  // Oriented outwards, including the mirrored instance.
  const size_t half = all.positions.size() / 2;
  std::set<float> copies;
  for (size_t v = 0; v < all.positions.size(); ++v) {
    copies.insert(mesh::find_attribute(all, kCopyAttribute)->values[v]);
    EXPECT_NEAR(mesh::find_attribute(all, "height")->values[v],
                all.positions[v].y / (v < half ? 1 : 2), 1e-6);
    EXPECT_NEAR(all.normals[v].length(), 1, 1e-5);
  }
  EXPECT_EQ(copies.size(), 2u);
}

TEST(MergeInstances, KeepsCommonAttributesOnlyForAnyNumberOfThreads) {
  const mesh::Mesh plain = mesh::sphere_mesh(Vec3d(0), 1, 2);
  std::vector<MeshInstance> copies;
  for (uint64_t i = 0; i < 1000; ++i)
    copies.push_back({i % 2, Transform::translation({static_cast<double>(i), 0, 0}), RandomKey(i)});
  const mesh::Mesh all = merge_instances({block(), plain}, copies);
  EXPECT_EQ(mesh::find_attribute(all, "height"), nullptr);
  EXPECT_TRUE(all.normals.empty());
  with_threads(7, [&] {
    EXPECT_EQ(merge_instances({block(), plain}, copies), all);
    EXPECT_TRUE(merge_instances({}, {}).triangles.empty());
  });
}

}  // namespace
}  // namespace vug::flora
