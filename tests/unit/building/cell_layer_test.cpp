// SPDX-License-Identifier: Apache-2.0
// Cell layers are products: built once, cached, counted, and rejected for their size before the
// work.
#include <gtest/gtest.h>
#include <vug/base/memory.h>
#include <vug/base/progress.h>
#include <vug/building/builder.h>
#include <vug/loading/load.h>
#include <vug/mesh/topology.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::building {
namespace {

const std::string kBallScene =
    "volume rock = level_set(sphere(1m), voxel: 10cm)\nmesh wall on rock {}\n";

shot::Shot shot_of(const std::string& cells) {
  const loading::Loaded loaded = loading::load_text(kBallScene + cells + "\n", "skin.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  return loaded.shot;
}

TEST(CellLayer, IsBuiltOnceAndCached) {
  const shot::Shot shot =
      shot_of("cells skin on wall { spacing 10cm  steps 7  run sprinkle(attribute: \"wet\") }");
  BuildOptions options;
  options.max_memory = uint64_t{1} << 30;
  Builder builder(shot, options);
  const shot::CellsPtr cells = shot.meshes.back()->cells;
  builder.mesh(cells->on.at(0));
  const uint64_t room = builder.memory_budget();
  const CellLayerPtr layer = builder.cell_layer(cells);
  EXPECT_NEAR(static_cast<double>(layer->network().size()), 4 * kPi / 0.01, 0.2 * 4 * kPi / 0.01);
  EXPECT_EQ(layer->simulation.step(), 7);
  EXPECT_EQ(room - builder.memory_budget(), layer->simulation.bytes());
  // Three vectors, two numbers and about six links per cell, and its attributes.
  EXPECT_GT(layer->simulation.bytes(), layer->network().size() * (3 * 12 + 2 * 4 + 4 * 4 + 4));
  const auto& wet = layer->simulation.attributes().values<float>("wet");
  EXPECT_EQ(wet.size(), layer->network().size());
  EXPECT_FALSE(layer->relaxation.empty());

  const auto worn = builder.mesh(shot.meshes.back());
  EXPECT_TRUE(mesh::find_attribute(*worn, "wet"));
  EXPECT_EQ(builder.cell_layer(cells), layer);

  const shot::Shot again = shot;
  Builder next(again, options);
  next.reuse_from(std::move(builder));
  EXPECT_EQ(next.cell_layer(cells), layer);
}

TEST(CellLayer, ScattersNewCellsOnASurfaceThatGrows) {
  const auto more = [](const std::string& name) {
    return fmt::format("set(attribute: \"{0}\", to: add([value(name: \"{0}\"), 0.01]), steps: 20)",
                       name);
  };
  const std::string grow = "run " + more("height") + ", " + more("layer");
  std::vector<double> cells;
  for (const int times : {0, 3}) {
    const shot::Shot shot = shot_of(fmt::format(
        "cells skin on wall {{ spacing 10cm  steps 20  rescatter {}  {} }}", times, grow));
    Builder builder(shot, {});
    const CellLayerPtr layer = builder.cell_layer(shot.meshes.back()->cells);
    EXPECT_EQ(layer->simulation.step(), 20);
    cells.push_back(static_cast<double>(layer->network().size()));
    // Inherited by each generation of cells.
    for (const float thickness : layer->simulation.attributes().values<float>("layer"))
      ASSERT_NEAR(thickness, 0.2f, 1e-5f);
    for (const float height : layer->simulation.attributes().values<float>("height"))
      ASSERT_NEAR(height, 0.2f / static_cast<float>(times + 1), 1e-5f);
    const mesh::MeshPtr grown = builder.mesh(shot.meshes.back());
    for (const Vec3f& p : grown->positions) ASSERT_NEAR(p.length(), 1.2f, 0.02f);
    EXPECT_TRUE(mesh::inspect(*grown).boundary_edges == 0);
  }
  // The last ones lie on a ball with a radius of 1.15 m.
  EXPECT_NEAR(cells[1] / cells[0], 1.15 * 1.15, 0.03);
}

// The area is estimated only if a box full of surface would have too many cells.
TEST(CellLayer, TheAreaIsEstimatedIfMemoryIsShort) {
  const shot::Shot shot = shot_of("cells skin on wall { spacing 1cm  run voronoi }");
  constexpr double kArea = 4 * kPi, kCells = kArea / 1e-4;
  const auto estimates = [&](double bytes_per_cell) {
    bool estimated = false;
    Progress progress([&](const std::string& stage, double) {
      estimated = estimated || stage.find("estimating the memory") != std::string::npos;
    });
    BuildOptions options;
    options.max_memory = static_cast<uint64_t>(bytes_per_cell * kCells);
    Builder(shot, options, progress).require_mesh_memory(shot.meshes.back());
    return estimated;
  };
  EXPECT_FALSE(estimates(1e5));
  EXPECT_TRUE(estimates(600));  // Cells take 360.
}

TEST(CellLayer, TooManyCellsAreRejectedBeforeAnyWork) {
  const shot::Shot shot = shot_of("cells skin on wall { spacing 1mm  run voronoi }");
  BuildOptions options;
  options.max_memory = uint64_t{1} << 30;
  Builder builder(shot, options);
  try {
    builder.require_mesh_memory(shot.meshes.back());
    FAIL() << "12 million cells in a GiB";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
    EXPECT_NE(std::string(error.what()).find("cells would take about"), std::string::npos);
    EXPECT_EQ(error.where().line, 3);
    EXPECT_EQ(error.where().column, 22);
    EXPECT_EQ(error.hint().rfind("use a larger spacing", 0), 0u) << error.hint();
  }
  EXPECT_EQ(builder.seconds(), 0);
}

/// Two cubes side by side, `gap` metres apart, in one network.
std::string cubes(double gap) {
  return fmt::format(
      "volume left = level_set(box().translate((-0.5, 0, 0)), voxel: 5cm)\n"
      "volume right = level_set(box().translate(({}, 0, 0)), voxel: 5cm)\n"
      "mesh wall on left {{ paint (1, 0, 0) }}\n"
      "cells skin on wall, right {{ spacing 5cm  steps 3  run random_color(share: 5%) }}\n",
      0.5 + gap);
}

TEST(CellLayer, ObjectsThatTouchAreOneNetwork) {
  for (const double gap : {0.0, 0.3}) {
    const loading::Loaded loaded = loading::load_text(cubes(gap), "cubes.vug");
    ASSERT_TRUE(loaded.usable()) << loaded.report();
    Builder builder(loaded.shot);
    ASSERT_EQ(loaded.shot.meshes.size(), 3u);
    EXPECT_EQ(shot::declared_meshes(loaded.shot).size(), 2u) << "those that wear the cells";
    const cells::Network& n = builder.cell_layer(loaded.shot.meshes.back()->cells)->network();
    const auto pieces = cells::components(n.links);
    EXPECT_EQ(*std::max_element(pieces.begin(), pieces.end()), gap > 0 ? 1u : 0u);
    size_t across = 0, on_wall = 0;
    for (uint32_t i = 0; i < n.size(); ++i) {
      on_wall += n.object[i] == 0;
      const float x = n.position[i].x;  // cells of both cubes lie at the contact
      EXPECT_TRUE(std::fabs(x) < 1e-4F || (n.object[i] == 0) == (x < 0)) << n.position[i];
      for (const uint32_t to : n.links.of(i)) across += n.object[i] != n.object[to];
    }
    EXPECT_NEAR(static_cast<double>(on_wall), 0.5 * static_cast<double>(n.size()),
                0.05 * static_cast<double>(n.size()));
    // A row of 20 cells along each of four sides, each with at least one mutual link across the
    // line.
    if (gap > 0)
      EXPECT_EQ(across, 0u);
    else
      EXPECT_GT(across, 2u * 4 * 20 / 2);
  }
}

TEST(CellLayer, SeveralObjectsKeepTheirOwnMaterials) {
  const loading::Loaded loaded =
      loading::load_text(cubes(0) +
                             "material red = lambert(albedo: (0.8, 0.1, 0.1))\n"
                             "object a on skin { of wall  material red }\n"
                             "object b on skin { of right }\n"
                             "cells more on skin { spacing 10cm  run voronoi }\n"
                             "object c on more { of wall }\n"
                             "object all on skin {}\n",
                         "cubes.vug");
  ASSERT_TRUE(loaded.usable()) << loaded.report();
  const std::vector<shot::ObjectPlan>& objects = loaded.shot.objects;
  ASSERT_EQ(objects.size(), 5u);
  Builder builder(loaded.shot);
  const auto middle = [&](const shot::ObjectPlan& object) {
    return mesh::bounds(*builder.mesh(object.mesh)).center().x;
  };
  EXPECT_NEAR(middle(objects[0]), -0.5, 1e-3);
  EXPECT_TRUE(objects[0].material);
  EXPECT_NEAR(middle(objects[1]), 0.5, 1e-3);
  EXPECT_FALSE(objects[1].material);
  EXPECT_NEAR(middle(objects[2]), -0.5, 1e-3);
  EXPECT_TRUE(mesh::find_attribute(*builder.mesh(objects[2].mesh), "transparent"));
  EXPECT_EQ(objects[3].mesh, objects[0].mesh);
  EXPECT_EQ(objects[4].mesh, objects[1].mesh);
}

TEST(CellLayer, ACombinedMeshIsTheSumOfItsParts) {
  const loading::Loaded loaded =
      loading::load_text(cubes(0.3) + "render main { spp 1 }\n", "cubes.vug");
  ASSERT_TRUE(loaded.usable()) << loaded.report();
  Builder builder(loaded.shot);
  shot::MeshPlan both;
  both.parts = shot::declared_meshes(loaded.shot);
  const auto one = builder.mesh(std::make_shared<const shot::MeshPlan>(both));
  const auto a = builder.mesh(both.parts.at(0)), b = builder.mesh(both.parts.at(1));
  EXPECT_EQ(one->triangles.size(), a->triangles.size() + b->triangles.size());
  EXPECT_EQ(one->normals.size(), one->positions.size());
  for (const mesh::Attribute& each : one->attributes)
    EXPECT_EQ(each.values.size(), one->positions.size() * static_cast<size_t>(each.arity));
  EXPECT_NO_THROW(mesh::validate(*one, "both"));
  EXPECT_EQ(mesh::bounds(*one).max.x, mesh::bounds(*b).max.x);
}

TEST(CellLayer, RemovedCellsAreHoles) {
  const std::string gone =
      "cells skin on wall {{ spacing 10cm  holes {}  steps 12 "
      " run corrosion(share: 90%, loss: 50%, where: noise(noise: fbm(scale: 50cm), from: 0, to: "
      "0.05)) }}";
  const shot::Shot whole = shot_of(fmt::format(fmt::runtime(gone), "false")),
                   cut = shot_of(fmt::format(fmt::runtime(gone), "true"));
  Builder a(whole), b(cut);
  const auto full = a.mesh(whole.meshes.back()), left = b.mesh(cut.meshes.back());
  EXPECT_TRUE(mesh::inspect(*full).closed());
  const mesh::Topology topology = mesh::inspect(*left);
  EXPECT_GT(topology.boundary_loops, 5u);
  EXPECT_EQ(topology.nonmanifold_edges + topology.misoriented_edges, 0u);
  const auto& gone_at = mesh::find_attribute(*left, "transparent")->values;
  EXPECT_LE(*std::max_element(gone_at.begin(), gone_at.end()), 0.5F + 1e-6F);
  EXPECT_GT(gone_at.size(), 0u);
}

// An eroded mesh becomes a level set again, which supports further declarations as usual.
TEST(CellLayer, ADisplacedSurfaceBecomesALevelSetAgain) {
  const shot::Shot shot = shot_of(
      "cells skin on wall { spacing 5cm "
      " run sprinkle(attribute: \"height\", value: -0.05, share: 100%) }\n"
      "volume worn on skin { voxel 4cm }\n"
      "mesh again on worn {}\n"
      "cells more on worn { spacing 8cm  run voronoi }\n"
      "object ball on more {}");
  Builder builder(shot);
  const auto check = [&](const mesh::Mesh& mesh) {
    EXPECT_TRUE(mesh::inspect(mesh).closed());
    for (const Vec3f& p : mesh.positions) ASSERT_NEAR(p.length(), 0.95F, 0.1F * 0.05F);
  };
  check(*builder.mesh(shot.meshes.at(1)));
  check(*builder.mesh(shot.meshes.at(2)));
  check(*builder.mesh(shot.objects.at(0).mesh));
  const volume::LevelSet& worn = builder.level_set(shot.volumes.at(1));
  EXPECT_EQ(volume::check(worn).fault, "");
  EXPECT_EQ(worn.voxel(), 0.04);
  EXPECT_LT(worn.value(Vec3d(0.9, 0, 0)), 0);
  EXPECT_GT(worn.value(Vec3d(0.98, 0, 0)), 0);

  const shot::Shot still = shot_of(
      "cells skin on wall { spacing 5cm  move false "
      " run sprinkle(attribute: \"height\", value: -0.05, share: 100%) }");
  Builder other(still);
  EXPECT_EQ(other.mesh(still.meshes.at(1))->positions, other.mesh(still.meshes.at(0))->positions);
}

TEST(CellLayer, AMeshWithHolesBoundsNoSolid) {
  const shot::Shot shot = shot_of(
      "cells skin on wall { spacing 10cm  holes true  run corrosion(share: 30%, loss: 100%) }\n"
      "volume worn on skin {}");
  Builder builder(shot);
  try {
    builder.level_set(shot.volumes.back());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where().line, 4);
    EXPECT_NE(std::string(error.what()).find("open edges"), std::string::npos) << error.what();
  }
  EXPECT_EQ(shot.volumes.back()->voxel, 0.1) << "that of the mesh's own level set";
}

}  // namespace
}  // namespace vug::building
