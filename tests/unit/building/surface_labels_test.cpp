// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/building/builder.h>
#include <vug/building/surface_labels.h>
#include <vug/field/registry.h>
#include <vug/loading/load.h>

#include <gtest/gtest.h>

namespace vug::building {
namespace {

field::Field ball(double radius, double x) {
  const field::Field centred = field::make("sphere", {{"radius", radius}});
  return field::make("translate", {{"field", field::as_value(centred)}, {"by", Vec3d(x, 0, 0)}});
}

TEST(SurfaceLabels, TheNearestSolidCounts) {
  mesh::Mesh mesh;
  for (const float x : {0.f, 2.f, 4.f, 6.f, 9.f}) mesh.positions.push_back({x, 1, 0});
  // The second "pool" is nearest at x = 9; at x = 6 it is as near as "hall", which is first.
  add_labels(mesh, {{"pool", ball(1, 0)}, {"hall", ball(1, 4)}, {"pool", ball(1, 8)}});
  ASSERT_EQ(mesh.attributes.size(), 2u);
  EXPECT_EQ(mesh.attributes[0].name, "pool");
  EXPECT_EQ(mesh.attributes[1].name, "hall");
  EXPECT_EQ(std::vector<float>(mesh.attributes[0].values.begin(), mesh.attributes[0].values.end()),
            (std::vector<float>{1, 1, 0, 0, 1}));
  for (size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_EQ(mesh.attributes[0].values[i] + mesh.attributes[1].values[i], 1);
}

// 400 labels of 190,000 vertices take 300 MB; the mesh and its grid take less than 200 MB.
TEST(SurfaceLabels, ManyLabelsNeedMemory) {
  const loading::Loaded loaded = loading::load_text(
      "volume rock = level_set(sphere(1m), voxel: 1cm)\nmesh wall on rock {}\n", "labels.vug");
  ASSERT_TRUE(loaded.usable()) << loaded.report();
  shot::MeshPlan plan = *loaded.shot.meshes.back();
  BuildOptions options;
  options.max_memory = uint64_t{250} << 20;
  Builder builder(loaded.shot, options);
  builder.require_mesh_memory(std::make_shared<const shot::MeshPlan>(plan));
  for (int i = 0; i < 400; ++i) plan.labels.push_back({std::to_string(i % 4), ball(1, i)});
  builder.require_mesh_memory(std::make_shared<const shot::MeshPlan>(plan));  // Four attributes.
  for (size_t i = 0; i < 400; ++i) plan.labels[i].name = std::to_string(i);
  try {
    builder.require_mesh_memory(std::make_shared<const shot::MeshPlan>(plan));
    ADD_FAILURE() << "expected an error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
  }
}

TEST(SurfaceLabels, NoLabelsAddNothing) {
  mesh::Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  add_labels(mesh, {});
  EXPECT_TRUE(mesh.attributes.empty());
}

}  // namespace
}  // namespace vug::building
