// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/building/builder.h>
#include <vug/building/cell_points.h>
#include <vug/building/rock_weights.h>
#include <vug/field/material_source.h>
#include <vug/loading/load.h>
#include <vug/mesh/rock_weights.h>
#include <vug/shot/queries.h>
#include <vug/volume/band.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::building {
namespace {

/// Limestone below y = 0 and shale above, with a contact of 20 cm, and calcite on top.
const std::string kRocks =
    "let host = host_rock(sphere(1m), of: \"shale\", contact: 20cm,\n"
    "  bodies: [made_of(half_space(), of: \"limestone\")])\n"
    "let both = union([host, made_of(sphere(0.5m).translate((0, 1, 0)), of: \"calcite\")],\n"
    "  blend: smooth(20cm))\n"
    "volume rock = level_set(both, voxel: 5cm)\nmesh wall on rock {}\n";

class RockWeights : public testing::Test {
 protected:
  static loading::Loaded load(const std::string& text = kRocks) {
    loading::Loaded out = loading::load_text(text, "rocks.vug");
    EXPECT_TRUE(out.usable()) << out.report();
    return out;
  }
};

TEST_F(RockWeights, VerticesHaveTheWeightsOfTheField) {
  const loading::Loaded loaded = load();
  Builder builder(loaded.shot);
  const mesh::MeshPtr mesh = builder.mesh(loaded.shot.meshes.back());
  ASSERT_EQ(mesh::rock_materials(*mesh),
            (std::vector<std::string>{"calcite", "limestone", "shale"}));
  const auto& calcite = mesh::find_attribute(*mesh, "w_calcite")->values;
  const auto& limestone = mesh::find_attribute(*mesh, "w_limestone")->values;
  const auto& shale = mesh::find_attribute(*mesh, "w_shale")->values;
  for (size_t v = 0; v < mesh->positions.size(); ++v) {
    const double y = static_cast<double>(mesh->positions[v].y);
    EXPECT_NEAR(calcite[v] + limestone[v] + shale[v], 1, 1e-6);
    if (y < -0.1) {
      EXPECT_EQ(limestone[v], 1);
    }
    if (y > 1.1) {
      EXPECT_EQ(calcite[v], 1);
    }
    const double t = std::min(1.0, std::max(0.0, 0.5 - y / 0.2));
    if (y < 0.3) {
      EXPECT_NEAR(static_cast<double>(limestone[v]), t * t * (3 - 2 * t), 1e-6);
    }
  }
}

// A layer of half a millimetre on rough rock, whose vertices a draft leaves off the surface.
TEST_F(RockWeights, DraftsHaveTheWeightsOfTheSurface) {
  loading::Loaded loaded = load(
      "let bare = made_of(displace(sphere(1m), noise: fbm(scale: 50cm, octaves: 4), amount: "
      "15cm),\n"
      "  of: \"limestone\")\n"
      "let thin = host_rock(bare, of: \"calcite\", bodies: [offset(bare, by: 0.5mm)], contact: "
      "1mm)\n"
      "volume rock = level_set(thin, voxel: 8cm)\nmesh wall on rock {}\n");
  loaded.shot.draft = true;
  Builder builder(loaded.shot);
  const mesh::MeshPtr mesh = builder.mesh(loaded.shot.meshes.back());
  const auto& calcite = mesh::find_attribute(*mesh, "w_calcite")->values;
  const auto wrong =
      std::count_if(calcite.begin(), calcite.end(), [](float w) { return w > 0.5F; });
  EXPECT_LT(static_cast<double>(wrong), 0.01 * static_cast<double>(calcite.size()));
}

TEST_F(RockWeights, AFieldWithoutMaterialsAddsNothing) {
  const loading::Loaded loaded =
      load("volume rock = level_set(sphere(1m), voxel: 10cm)\nmesh wall on rock {}\n");
  Builder builder(loaded.shot);
  EXPECT_TRUE(builder.mesh(loaded.shot.meshes.back())->attributes.empty());
  EXPECT_TRUE(rock_grids(*loaded.shot.volumes[0], builder.level_set(loaded.shot.volumes[0]), "", 1)
                  .empty());
}

// The numbers are those of the largest weights, and all grids have the same bytes for any number of
// threads.
TEST_F(RockWeights, TheGridOfNumbersAgreesWithThatOfWeights) {
  const loading::Loaded loaded = load();
  Builder builder(loaded.shot);
  const shot::VolumePtr& plan = loaded.shot.volumes[0];
  const volume::LevelSet& level_set = builder.level_set(plan);
  const auto grids = [&] { return rock_grids(*plan, level_set, "rock_", uint64_t{1} << 30); };
  const std::vector<volume::Grid> made = grids();
  ASSERT_EQ(made.size(), 4u);
  const char* names[] = {"rock_material", "rock_w_calcite", "rock_w_limestone", "rock_w_shale"};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(made[i].name(), names[i]);
    EXPECT_EQ(made[i].value_type(), i == 0 ? "int32" : "float");
    EXPECT_EQ(made[i].statistics().active_voxels, level_set.statistics().active_voxels);
  }
  EXPECT_EQ(std::get<std::string>(made[0].metadata().at("vug:materials")),
            "calcite,limestone,shale");
  std::vector<int32_t> largest;
  std::vector<float> weights;
  for (const Vec3f& p : volume::band_positions(level_set)) {
    const field::MaterialMix mix = field::sample_materials(*plan->field.node(), Vec3d(p)).mix;
    const double w[] = {mix.weight("calcite"), mix.weight("limestone"), mix.weight("shale")};
    largest.push_back(static_cast<int32_t>(std::max_element(w, w + 3) - w) + 1);
    weights.push_back(static_cast<float>(w[1]));
  }
  EXPECT_EQ(made[0].content(), volume::band_grid(level_set, largest).content());
  EXPECT_EQ(made[2].content(), volume::band_grid(level_set, weights).content());
  for (const int threads : {1, 2, 7})
    with_threads(threads, [&] {
      const std::vector<volume::Grid> again = grids();
      for (size_t i = 0; i < 4; ++i) EXPECT_EQ(again[i].content(), made[i].content());
    });
}

TEST_F(RockWeights, PointsOfCellsHaveThemToo) {
  const loading::Loaded loaded = load(
      kRocks + "cells crust on wall { spacing 20cm  run random_color(share: 10%)  steps 1 }\n");
  Builder builder(loaded.shot);
  const shot::CellsPtr plan = shot::declared_cells(loaded.shot).at(0);
  const CellLayerPtr layer = builder.cell_layer(plan);
  const volume::Grid grid = cell_points(*plan, *layer);
  EXPECT_EQ(std::get<std::string>(grid.metadata().at("vug:materials")), "calcite,limestone,shale");
  const volume::Points points = volume::points(grid);
  ASSERT_GT(points.size(), 100u);
  const auto &number = points.values<int32_t>("material"), &id = points.values<int32_t>("id");
  const auto &calcite = points.values<float>("w_calcite"),
             &limestone = points.values<float>("w_limestone"),
             &shale = points.values<float>("w_shale");
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(calcite[i] + limestone[i] + shale[i], 1, 1e-6);
    const Vec3f& cell = layer->network().position[static_cast<size_t>(id[i])];
    if (cell.y < -0.1f) {
      EXPECT_EQ(number[i], 2);
    }
    if (cell.y > 1.1f) {
      EXPECT_EQ(number[i], 1);
    }
  }
  // They belong to the rock, so a checkpoint of the cells does not contain them.
  const volume::Grid kept = cell_points(*plan, *layer, cells::PointFormat::exact);
  EXPECT_EQ(kept.metadata().count("vug:materials"), 0u);
  cells::Simulation again = layer->simulation;
  restore_cells(grid, again);
  EXPECT_EQ(again.attributes().find("w_shale"), nullptr);
}

TEST_F(RockWeights, GridsRespectTheLimitOfMemory) {
  const loading::Loaded loaded = load();
  Builder builder(loaded.shot);
  const shot::VolumePtr& plan = loaded.shot.volumes[0];
  EXPECT_THROW(rock_grids(*plan, builder.level_set(plan), "", 1000), Error);
}

}  // namespace
}  // namespace vug::building
