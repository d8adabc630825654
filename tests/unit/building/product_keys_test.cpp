// SPDX-License-Identifier: Apache-2.0
#include <vug/building/product_keys.h>
#include <vug/field/registry.h>

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace vug::building {
namespace {

shot::VolumePlan volume() {
  shot::VolumePlan out;
  out.name = "rock";
  out.field = field::make("sphere", {{"radius", 2.0}});
  return out;
}
shot::MeshPlan mesh_on(const shot::VolumePlan& volume) {
  shot::MeshPlan out;
  out.name = "skin";
  out.volume = std::make_shared<const shot::VolumePlan>(volume);
  return out;
}
std::string key_of(const shot::VolumePlan& plan) { return level_set_key(plan).digest().hex(); }
std::string key_of(const shot::MeshPlan& plan, bool draft = false) {
  return surface_mesh_key(plan, draft).digest().hex();
}

TEST(ProductKeys, DependOnAllThatDeterminesTheBytes) {
  const std::vector<std::function<void(shot::VolumePlan&)>> edits = {
      [](auto& v) {
        v.field = field::make("sphere", {{"radius", 2.1}});
      },
      [](auto& v) { v.voxel = 0.2; },
      [](auto& v) { v.half_width = 4; },
      [](auto& v) { v.repair = false; },
      [](auto& v) { v.from = v.to = Vec3d(1); },
  };
  std::set<std::string> level_sets{key_of(volume())}, meshes{key_of(mesh_on(volume()))};
  for (const auto& edit : edits) {
    shot::VolumePlan changed = volume();
    edit(changed);
    EXPECT_TRUE(level_sets.insert(key_of(changed)).second);
    EXPECT_TRUE(meshes.insert(key_of(mesh_on(changed))).second);
  }
  const std::vector<std::function<void(shot::MeshPlan&)>> mesh_edits = {
      [](auto& m) { m.adaptivity = 0.5; },
      [](auto& m) { m.polish = false; },
      [](auto& m) { m.topology = shot::SmallTopology::keep; },
      [](auto& m) { m.smallest_piece = 1; },
  };
  for (const auto& edit : mesh_edits) {
    shot::MeshPlan changed = mesh_on(volume());
    edit(changed);
    EXPECT_TRUE(meshes.insert(key_of(changed)).second);
  }
}

TEST(ProductKeys, DependOnNothingElse) {
  shot::VolumePlan other = volume();
  other.name = "other";
  other.half = true;
  other.where = {"scene.vug", 3, 4};
  EXPECT_EQ(key_of(other), key_of(volume()));
  shot::MeshPlan mesh = mesh_on(other);
  mesh.name = "other";
  mesh.format = "obj";
  EXPECT_EQ(key_of(mesh), key_of(mesh_on(volume())));
  mesh.polish = false;
  EXPECT_EQ(key_of(mesh), key_of(mesh_on(volume()), true)) << "drafts are not polished";
}

TEST(ProductKeys, OfVoxelisedMeshesDependOnTheirTrianglesAlone) {
  mesh::Mesh source{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}};
  const auto key = [&] { return level_set_key(volume(), &source).digest().hex(); };
  const std::string before = key();
  source.attributes.push_back({"Cd", 1, {1, 2, 3}});
  EXPECT_EQ(key(), before) << "colours do not matter";
  source.positions[2].z = 1;
  EXPECT_NE(key(), before);
}

}  // namespace
}  // namespace vug::building
