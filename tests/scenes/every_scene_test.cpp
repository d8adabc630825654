// SPDX-License-Identifier: Apache-2.0
// Builds every scene of data/scenes, compares its meshes with known facts, and checks the
// guarantees for all scenes: closed surfaces on the field without intersecting triangles, valid
// level sets.
#include "../unit/scan/external_data.h"
#include "facts.h"

#include <vug/base/scratch_folder.h>
#include <vug/building/builder.h>
#include <vug/delivery/write_products.h>
#include <vug/mesh/displacement.h>
#include <vug/mesh/topology.h>
#include <vug/shot/cells_plan.h>
#include <vug/shot/queries.h>
#include <vug/volume/io.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

namespace vug::session {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Whether the volume's region clips the solid near the point.
bool near_cut(const shot::VolumePlan& plan, const Vec3d& p) {
  if (!plan.from) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < (*plan.from)[axis] + 2 * plan.voxel ||
        p[axis] > (*plan.to)[axis] - 2 * plan.voxel)
      return true;
  return false;
}

/// Root mean square of the vertices' distances from the exact surface, to first order, in voxels.
double rms_distance(const mesh::Mesh& mesh, const shot::VolumePlan& plan) {
  double squares = 0;
  size_t count = 0;
  for (const Vec3f& v : mesh.positions) {
    const Vec3d p(v);
    if (near_cut(plan, p)) continue;
    const field::Gradient at = plan.field.gradient(p);
    const double slope = at.gradient.length();
    const double distance = at.value / (std::max(slope, 1e-3) * plan.voxel);
    squares += distance * distance;
    ++count;
  }
  return count ? std::sqrt(squares / static_cast<double>(count)) : 0;
}

/// The mesh without cells, which may have displaced it.
shot::MeshPtr bare(const shot::MeshPtr& plan) {
  const shot::MeshPtr under = shot::mesh_without_cells(*plan);
  return under ? bare(under) : plan;
}

/// Whether the mesh may be open: holes are cut by cells or come from a file.
bool may_be_open(const shot::MeshPtr& plan) {
  const shot::MeshPtr under = shot::mesh_without_cells(*plan);
  return under ? plan->cells->holes || may_be_open(under) : plan->file_mesh != nullptr;
}

/// Expects that the displacement by cells folded no triangle.
void expect_no_folds(building::Builder& builder, const shot::MeshPtr& plan) {
  const shot::MeshPtr under = shot::mesh_without_cells(*plan);
  if (!under) return;
  const mesh::MeshPtr before = builder.mesh(under), after = builder.mesh(plan);
  if (before->triangles != after->triangles) return;  // subdivided or with holes
  EXPECT_TRUE(mesh::folded_triangles(before->positions, *after).empty());
}

void expect_sound(building::Builder& builder, const shot::MeshPtr& plan, double residual) {
  const mesh::Topology topology = mesh::inspect(*builder.mesh(plan));
  EXPECT_TRUE(may_be_open(plan) || topology.boundary_edges == 0);
  EXPECT_EQ(topology.nonmanifold_edges, 0U);
  EXPECT_EQ(topology.misoriented_edges, 0U);
  EXPECT_EQ(topology.unused_vertices, 0U);
  expect_no_folds(builder, plan);
  const shot::MeshPtr under = bare(plan);
  if (!under->volume || under->volume->source_mesh) return;
  EXPECT_LT(rms_distance(*builder.mesh(under), *under->volume), residual);
}

/// Measures a mesh, which must be valid. Stems may penetrate each other where they branch, and
/// lines of curves that touch themselves intersect as often as known.
metrics::Report measured(const mesh::Mesh& mesh, const shot::MeshPtr& plan, const json& known) {
  const metrics::Report report =
      metrics::measure(mesh, {.overlapping_components = shot::components_may_overlap(plan)});
  EXPECT_EQ(report.self_intersections, known.value("self_intersections", size_t{0}));
  EXPECT_EQ(report.zero_area_triangles, 0U);
  EXPECT_EQ(report.folded_triangles, 0U);
  return report;
}

/// Writes the level sets and fog volumes like `vug build` and verifies the files.
void expect_written(building::Builder& builder) {
  const ScratchFolder folder("vug_scenes");
  const std::vector<fs::path> paths = delivery::write_products(builder, folder.path());
  ASSERT_FALSE(paths.empty());
  for (const shot::VolumePtr& plan : builder.shot().volumes) {
    const volume::Grid grid = volume::read_grid(paths.front(), plan->name);
    if (plan->fog) {
      EXPECT_EQ(grid.grid_class(), volume::GridClass::fog) << plan->name;
      EXPECT_GT(grid.statistics().active_voxels, 0U) << plan->name;
    } else {
      EXPECT_EQ(volume::check(volume::LevelSet(grid)).fault, "") << plan->name;
    }
  }
  for (const fs::path& path : paths) EXPECT_GT(fs::file_size(path), 0U) << path;
}

bool has_mesh(const shot::Shot& shot, const std::string& name) {
  const std::vector<shot::MeshPtr> meshes = shot::shown_meshes(shot);
  return std::any_of(meshes.begin(), meshes.end(),
                     [&](const shot::MeshPtr& plan) { return plan->name == name; });
}

/// The overrides in the facts of a scene: "defines", and "external", files of the external test
/// data by parameter. Nothing if one of these files is missing.
std::optional<std::vector<scene::Override>> overrides_of(const json& facts) {
  std::vector<scene::Override> overrides;
  const json defines = facts.value("defines", json::object());
  for (const auto& [name, value] : defines.items())
    overrides.push_back({name, value.get<std::string>()});
  const json external = facts.value("external", json::object());
  for (const auto& [name, value] : external.items()) {
    const fs::path file = external_data() / value.get<std::string>();
    if (!fs::exists(file)) return {};
    overrides.push_back({name, '"' + fs::canonical(file).generic_string() + '"'});
  }
  return overrides;
}

class EveryScene : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryScene, IsAsKnown) {
  const json& scenes = scene_facts().at("scenes");
  ASSERT_TRUE(scenes.contains(GetParam()))
      << "add the figures to tests/data/scene_facts.json for " << GetParam();
  const json& facts = scenes.at(GetParam());
  const auto overrides = overrides_of(facts);
  if (!overrides) GTEST_SKIP() << "set VUG_EXTERNAL_DATA to a folder with " << facts.at("external");
  const loading::Loaded loaded = load_scene(GetParam(), *overrides);
  ASSERT_TRUE(loaded.usable());
  expect_words(loaded.shot, facts);
  ASSERT_TRUE(facts.contains("words") || !shot::shown_meshes(loaded.shot).empty());
  building::Builder builder(loaded.shot);
  for (const shot::MeshPtr& plan : shot::shown_meshes(loaded.shot)) {
    SCOPED_TRACE(plan->name);
    const auto mesh = builder.mesh(plan);
    const json& known =
        facts.at("meshes").contains(plan->name) ? facts.at("meshes") : scene_facts().at("shared");
    ASSERT_TRUE(known.contains(plan->name)) << "no facts about this mesh";
    expect_sound(builder, plan, known.at(plan->name).value("residual", 0.01));
    expect_facts(measured(*mesh, plan, known.at(plan->name)), known.at(plan->name));
    expect_attributes(*mesh, known.at(plan->name));
  }
  const json meshes = facts.value("meshes", json::object());
  for (const auto& entry : meshes.items())
    EXPECT_TRUE(has_mesh(loaded.shot, entry.key())) << "the scene has no mesh " << entry.key();
  if (!shot::shown_meshes(loaded.shot).empty()) expect_written(builder);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = fs::path(info.param).replace_extension().generic_string();
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Data, EveryScene, ::testing::ValuesIn(scene_names()), test_name);

// The list of tests is fixed at build time; the list of scenes is on disk.
TEST(Scenes, FactsAndFilesAreTheSameScenes) {
  std::vector<std::string> known;
  for (const auto& [name, facts] : scene_facts().at("scenes").items()) known.push_back(name);
  EXPECT_EQ(known, scene_names());
}

}  // namespace
}  // namespace vug::session
