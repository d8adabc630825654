// SPDX-License-Identifier: Apache-2.0
// Conversion of scenes to plain data for other programs.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/delivery/assembly.h>
#include <vug/delivery/export_set.h>
#include <vug/loading/load.h>
#include <vug/paint/leaf_pattern.h>
#include <vug/volume/density.h>
#include <vug/volume/io.h>
#include <vug/volume/points.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::delivery {
namespace {

constexpr const char* kScene = R"(
seed 5
volume rock = level_set(box(size: (1, 1, 1)), voxel: 10cm)
volume mist = fog(sphere(1m), voxel: 25cm)
volume stone = level_set(sphere(30cm), voxel: 10cm)
mesh wall on rock { paint layer(under: (0.5, 0.4, 0.3), over: (0.1, 0.2, 0.04), mask: height(from: -40cm, to: 40cm)) }
mesh pebble on stone {}
material wet = surface(color: (0.5, 1, 1), roughness: 0.6, coat: height(from: -40cm, to: 40cm))
object wall on wall { material wet }
object glow on pebble { emission (2, 1, 0.5) }
place heap { of glow at [(3, 0, 0), (4, 0, 0)] }
camera main { eye (0, 2, 6) fov 60deg }
camera round { kind panoramic }
light ball = sphere(center: (0, 3, 0), power: 100)
render main { size 300x100 }
)";

struct Made {
  loading::Loaded loaded;
  shot::Shot shot;
  AssemblyResult out;

  explicit Made(const std::string& text = kScene) {
    loaded = loading::load_text(text, "t.vug", {});
    EXPECT_EQ(loaded.report(), "");
    shot = with_meshes(loaded.shot);
    building::Builder builder(shot);
    out = build_assembly(builder);
  }
};

/// The triangles of the only object, a ball with this detail.
size_t triangles_with(const std::string& detail) {
  const Made made(
      "volume rock = level_set(sphere(1m), voxel: 20cm)\nmesh skin on rock {}\n"
      "object ball on skin { " +
      detail + " }\n");
  return made.out.assembly.prototypes.at(0).mesh->triangles.size();
}

TEST(Assemble, DetailWithAFixedEdgeIsExported) {
  const size_t plain = triangles_with("");
  EXPECT_EQ(triangles_with("detail dice(pixels: 1)"), plain);
  EXPECT_GT(triangles_with("detail dice(edge: 4cm)"), 16 * plain);
}

TEST(Assemble, WhatAShotShows) {
  const Made made;
  const exchange::Assembly& all = made.out.assembly;
  ASSERT_EQ(all.prototypes.size(), 2u);
  ASSERT_EQ(all.groups.size(), 2u);
  EXPECT_EQ(all.groups[0].name, "wall");
  EXPECT_EQ(all.groups[1].name, "heap");
  EXPECT_EQ(all.groups[1].places.size(), 2u);
  EXPECT_EQ(all.groups[1].places[1].origin(), Vec3d(4, 0, 0));
  ASSERT_EQ(all.cameras.size(), 1u);
  EXPECT_EQ(all.cameras[0].aspect, 3);
  ASSERT_EQ(all.lights.size(), 1u);
  EXPECT_EQ(all.lights[0].name, "ball");
  EXPECT_NEAR(exchange::luminance(exchange::power(all.lights[0])), 100, 1e-3);
  EXPECT_EQ(all.provenance.recipe, kScene);
  EXPECT_EQ(all.provenance.seed, 5u);
  ASSERT_EQ(made.out.unsupported.size(), 1u);
  EXPECT_NE(made.out.unsupported[0].find("round"), std::string::npos);
}

TEST(Assemble, LooksAreBakedAtTheVertices) {
  const Made made;
  const exchange::Prototype& wall = made.out.assembly.prototypes[0];
  const mesh::Attribute* color = mesh::find_attribute(*wall.mesh, "Cd", 3);
  const mesh::Attribute* wet = mesh::find_attribute(*wall.mesh, "wetness", 1);
  ASSERT_TRUE(color && wet);
  // No other channel of the look varies.
  EXPECT_EQ(wall.mesh->attributes.size(), 2u);
  EXPECT_NEAR(wall.look.roughness, 0.6, 1e-6);
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  for (size_t v = 0; v < wall.mesh->positions.size(); ++v) {
    const auto y = static_cast<double>(wall.mesh->positions[v].y);
    const double t = smooth(std::clamp((y + 0.4) / 0.8, 0.0, 1.0));
    EXPECT_NEAR(static_cast<double>(wet->values[v]), t, 1e-5);
    // The paint multiplied by the material's colour.
    EXPECT_NEAR(static_cast<double>(color->values[3 * v]), 0.5 * (0.5 + t * (0.1 - 0.5)), 1e-5);
  }
}

TEST(Assemble, FlatObjectsHaveNoNormals) {
  const Made made(R"(
volume ball = level_set(sphere(30cm), voxel: 10cm)
mesh skin on ball {}
object even on skin {}
object edged on skin { flat true }
camera main { eye (0, 2, 6) fov 60deg }
)");
  const std::vector<exchange::Prototype>& parts = made.out.assembly.prototypes;
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].mesh->normals.size(), parts[0].mesh->positions.size());
  EXPECT_TRUE(parts[1].mesh->normals.empty());
  EXPECT_EQ(parts[1].mesh->positions.size(), parts[0].mesh->positions.size());
}

TEST(Assemble, EmissiveObjectsHaveAnEmissiveLook) {
  const Made made;
  const exchange::Prototype& glow = made.out.assembly.prototypes[1];
  EXPECT_LT((glow.look.emission - Vec3d(2, 1, 0.5)).length(), 1e-6);
  EXPECT_TRUE(glow.mesh->attributes.empty());
  EXPECT_EQ(glow.look.base_color, Vec3d(0.5));
}

TEST(ExportSet, AirIsCalledAir) {
  const loading::Loaded scene = loading::load_text(
      "let room = sphere(1m)\nvolume rock = level_set(box(size: (3, 3, 3)) - room, voxel: 20cm)\n"
      "volume air = level_set(room, voxel: 20cm)\n",
      "t.vug", {});
  ASSERT_TRUE(scene.usable()) << scene.report();
  const ScratchFolder scratch("vug_export_air");
  const std::filesystem::path& folder = scratch.path();
  ExportOptions options;
  options.program = exchange::programs().front();
  const shot::Shot shot = with_meshes(scene.shot);
  building::Builder builder(shot);
  export_set(builder, folder, options);
  EXPECT_EQ(volume::info(folder / "t_air.vdb").grids.at(0).name, "air");
  EXPECT_EQ(volume::info(folder / "t_rock.vdb").grids.at(0).name, "surface");
}

TEST(Assemble, EachRockHasALookOfItsOwn) {
  const Made made(
      "let beds = [made_of(slab(thickness: 60cm), of: \"clay\")]\n"
      "volume rock = level_set(host_rock(sphere(1m), of: \"lime\", bodies: beds, contact: 10cm), "
      "voxel: 5cm)\n"
      "mesh wall on rock {}\n"
      "object o on wall { material by rock {\n"
      "  lime -> surface(color: (0.8, 0.8, 0.7), roughness: 0.9, ior: 1.4, matte: 0)\n"
      "  clay -> surface(color: (0.3, 0.2, 0.1), roughness: 0.2, ior: 1.6, matte: 0)\n} }\n");
  const exchange::Prototype& wall = made.out.assembly.prototypes.at(0);
  ASSERT_EQ(wall.rocks.size(), 2u);
  EXPECT_EQ(wall.rocks[0].rock, "clay");
  EXPECT_EQ(wall.rocks[1].rock, "lime");
  // Only the triangles in the contact, about a twelfth of the bed, mix the two.
  const exchange::Look &clay = wall.rocks[0].look, &lime = wall.rocks[1].look;
  EXPECT_NEAR(clay.roughness, 0.2, 0.05);
  EXPECT_NEAR(lime.roughness, 0.9, 0.05);
  EXPECT_NEAR(clay.ior, 1.6, 0.02);
  EXPECT_NEAR(lime.ior, 1.4, 0.02);
  EXPECT_NEAR(clay.base_color.x, 0.3, 0.04);
  EXPECT_NEAR(lime.base_color.x, 0.8, 0.04);
  EXPECT_GT(wall.look.roughness, clay.roughness + 0.1);
  EXPECT_LT(wall.look.roughness, lime.roughness - 0.1);
}

TEST(Assemble, RockMaterialsAreGridsOfTheVolumeAndAttributesOfPoints) {
  const loading::Loaded scene = loading::load_text(
      "volume rock = level_set(made_of(sphere(1m), of: \"limestone\"), voxel: 10cm)\n"
      "mesh wall on rock {}\n"
      "cells crust on wall { spacing 30cm  run random_color(share: 10%) }\n",
      "t.vug", {});
  ASSERT_TRUE(scene.usable()) << scene.report();
  const ScratchFolder scratch("vug_export_rocks");
  const std::filesystem::path& folder = scratch.path();
  ExportOptions options;
  options.program = &exchange::program("maya");
  const shot::Shot shot = with_meshes(scene.shot);
  building::Builder builder(shot);
  export_set(builder, folder, options);
  const std::vector<volume::Grid> grids = volume::read(folder / "t_rock.vdb");
  ASSERT_EQ(grids.size(), 3u);
  EXPECT_EQ(grids[1].name(), "material");
  EXPECT_EQ(grids[2].name(), "w_limestone");
  EXPECT_EQ(grids[1].voxel_size(), grids[0].voxel_size());  // Centimetres.
  const std::string text = read_text(folder / "t.usda");
  const size_t number = text.find("def OpenVDBAsset \"material\"");
  ASSERT_NE(number, std::string::npos);
  EXPECT_EQ(text.find("fieldDataType = \"int\"", number), text.find("fieldDataType", number));
  const std::vector<float> weights =
      volume::read_points(folder / "t_crust_points.vdb").values<float>("w_limestone");
  EXPECT_FALSE(weights.empty());
  for (const float weight : weights) EXPECT_EQ(weight, 1);
}

TEST(Assemble, WorldSpaceMaterialsAreBakedPerInstance) {
  const std::string text = R"(
volume stone = level_set(sphere(30cm), voxel: 10cm)
mesh pebble on stone {}
material grown = surface(color: layer(under: (0.5, 0.4, 0.3), over: (0.1, 0.2, 0.04), mask: height(from: 0m, to: 4m)))
material plain = lambert(albedo: (0.3, 0.3, 0.3))
place tower { of pebble at [(0, 0, 0), (5, 0, 0), pose(position: (0, 2, 0), scale: 2), (0, 9, 0)] material grown }
place row { of pebble at [(0, 0, 3), (1, 0, 3)] material plain }
)";
  const Made made(text);
  const exchange::Assembly& all = made.out.assembly;
  EXPECT_TRUE(made.out.unsupported.empty());
  // Two are on the same ground, and equal looks share a prototype.
  ASSERT_EQ(all.prototypes.size(), 4u);
  std::vector<std::string> names;
  for (const exchange::InstanceGroup& group : all.groups) names.push_back(group.name);
  EXPECT_EQ(names, (std::vector<std::string>{"tower", "tower_2", "tower_3", "row"}));
  EXPECT_EQ(all.groups[0].places.size(), 2u);
  EXPECT_EQ(all.groups[3].places.size(), 2u);
  const auto red = [&](size_t group, float height) {
    const exchange::Prototype& part = all.prototypes[all.groups[group].prototype];
    const mesh::Attribute* color = mesh::find_attribute(*part.mesh, "Cd", 3);
    if (!color) return part.look.base_color.x;
    for (size_t v = 0; v < part.mesh->positions.size(); ++v)
      if (std::fabs(part.mesh->positions[v].y - height) < 0.011f)
        return static_cast<double>(color->values[3 * v]);
    return -1.0;
  };
  const auto wanted = [](double y) {
    const double t = std::clamp(y / 4, 0.0, 1.0);
    return 0.5 + t * t * (3 - 2 * t) * (0.1 - 0.5);
  };
  EXPECT_NEAR(red(0, 0.3f), wanted(0.3), 2e-2);
  EXPECT_NEAR(red(1, 0.3f), wanted(2.6), 2e-2);  // twice as large, at 2 m
  EXPECT_NEAR(red(1, -0.3f), wanted(1.4), 2e-2);
  EXPECT_NEAR(red(2, 0), 0.1, 1e-6);  // above the whole ramp
}

/// The noise of the stone itself is the same everywhere; its moss depends on the height in the
/// scene and the slope there.
TEST(Assemble, MasksOfAnObjectMayReferToTheScene) {
  const std::string text = R"(
volume stone = level_set(sphere(30cm), voxel: 10cm)
mesh pebble on stone {}
object own on pebble { material surface(roughness: height(from: 0m, to: 4m)) }
object grown on pebble { material surface(roughness: height(from: 0m, to: 4m, in: scene), coat: slope(in: scene)) }
place row { of own at [(0, 0, 0), (0, 2, 0)] }
place tower { of grown at [(0, 0, 0), pose(position: (0, 2, 0), scale: 2), pose(position: (0, 2, 0), roll: 180deg)] }
)";
  const Made made(text);
  const exchange::Assembly& all = made.out.assembly;
  ASSERT_EQ(all.groups.size(), 4u);
  EXPECT_EQ(all.groups[0].name, "row");
  EXPECT_EQ(all.groups[0].places.size(), 2u);
  const auto at = [&](size_t group, const char* name, float height) {
    const exchange::Prototype& part = all.prototypes[all.groups[group].prototype];
    const mesh::Attribute* values = mesh::find_attribute(*part.mesh, name, 1);
    for (size_t v = 0; values && v < part.mesh->positions.size(); ++v)
      if (std::fabs(part.mesh->positions[v].y - height) < 0.011f)
        return static_cast<double>(values->values[v]);
    return -1.0;
  };
  const auto wanted = [](double y) {
    const double t = std::clamp(y / 4, 0.0, 1.0);
    return t * t * (3 - 2 * t);
  };
  EXPECT_NEAR(at(1, "roughness", 0.3f), wanted(0.3), 2e-2);
  EXPECT_NEAR(at(2, "roughness", 0.3f), wanted(2.6), 2e-2);  // twice as large, at 2 m
  EXPECT_NEAR(at(3, "roughness", 0.3f), wanted(1.7), 2e-2);  // upside down
  EXPECT_LT(at(1, "wetness", 0.3f), 0.05);
  EXPECT_GT(at(3, "wetness", 0.3f), 0.95);
}

TEST(Assemble, ObjectsOfOnePlaceHaveUniqueNames) {
  const Made made(R"(
volume stone = level_set(sphere(30cm), voxel: 10cm)
volume block = level_set(box(size: (1, 1, 1)), voxel: 10cm)
mesh pebble on stone {}
mesh slab on block {}
object pebble on pebble {}
object slab on slab {}
place heap { of [pebble, slab] at [pose(position: (0, 0, 0), model: 0), pose(position: (3, 0, 0), model: 1)] }
)");
  std::vector<std::string> names;
  for (const exchange::InstanceGroup& group : made.out.assembly.groups) names.push_back(group.name);
  EXPECT_EQ(names, (std::vector<std::string>{"heap", "heap_2"}));
}

TEST(Assemble, WithoutLightsThereIsTheSkyOfThePicture) {
  const Made made("volume rock = level_set(sphere(1m), voxel: 20cm)\n");
  ASSERT_EQ(made.out.assembly.lights.size(), 1u);
  const exchange::Light& sky = made.out.assembly.lights[0];
  EXPECT_EQ(sky.name, "sky");
  EXPECT_EQ(sky.shape, exchange::Light::Shape::dome);
  EXPECT_LT((sky.radiance - Vec3d(0.9, 0.95, 1)).length(), 1e-6);
}

TEST(ExportSet, CloudsAreExportedWithTheirGrids) {
  const loading::Loaded scene = loading::load_text(R"(
volume banks = fog(sphere(1m), voxel: 10cm)
mesh ball on rock {}
volume rock = level_set(sphere(20cm), voxel: 10cm)
medium mist on banks { kind cloud extinction 2/m g 0.5 temperature 1800 temperature_mask height(from: -1m, to: 1m)
  albedo layer(under: (0.9, 0.5, 0.1), over: (0.1, 0.5, 0.9), mask: height(from: -1m, to: 1m)) }
)",
                                                   "t.vug", {});
  ASSERT_TRUE(scene.usable()) << scene.report();
  const ScratchFolder scratch("vug_export_cloud");
  const std::filesystem::path& folder = scratch.path();
  ExportOptions options;
  options.program = &exchange::program("maya");
  const shot::Shot shot = with_meshes(scene.shot);
  building::Builder builder(shot);
  const ExportResult written = export_set(builder, folder, options);
  EXPECT_TRUE(written.unsupported.empty());
  const std::vector<volume::Grid> grids = volume::read(folder / "t_banks.vdb");
  std::vector<std::string> names;
  for (const volume::Grid& grid : grids) names.push_back(grid.name());
  EXPECT_EQ(names, (std::vector<std::string>{"density", "color", "temperature"}));
  const volume::Density red(grids[1], 0), kelvin(grids[2]);
  for (const double y : {-0.4, 0.0, 0.4}) {
    const Vec3f centimetres(0, static_cast<float>(100 * y), 0);
    const double t = (y + 1) / 2, smooth = t * t * (3 - 2 * t);
    EXPECT_NEAR(red.at_world(centimetres), 0.9 + smooth * (0.1 - 0.9), 1e-2);
    EXPECT_NEAR(kelvin.at_world(centimetres), 1800 * smooth, 20);
  }
  std::string text = read_text(folder / "t.usda");
  EXPECT_NE(text.find("custom double vug:extinction = 0.02"), std::string::npos);
  EXPECT_NE(text.find("token vectorDataRoleHint = \"Color\""), std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST(ExportSet, CloudsOfFilesAndHazeAreReported) {
  const loading::Loaded fire = loading::load_text(
      "volume rock = level_set(sphere(1m), voxel: 20cm)\n"
      "medium fire = cloud(file: \"" VUG_TEST_DATA
      "/volumes/fire.vdb\", temperature: 1, "
      "temperature_grid: \"temperature\", emission_grid: \"flame\", color_grid: \"Cd\")\n",
      "t.vug", {});
  ASSERT_TRUE(fire.usable()) << fire.report();
  const ScratchFolder scratch("vug_export_fire");
  const std::filesystem::path& folder = scratch.path();
  ExportOptions options;
  options.program = &exchange::program("gltf");
  const shot::Shot shot = with_meshes(fire.shot);
  building::Builder builder(shot);
  const ExportResult written = export_set(builder, folder, options);
  const volume::FileInfo info = volume::info(folder / "t_fire_medium.vdb");
  ASSERT_EQ(info.grids.size(), 4u);
  EXPECT_EQ(info.grids[0].name, "density");
  EXPECT_EQ(info.grids[3].name, "flame");
  for (const auto& path : export_paths(shot, folder, options))
    EXPECT_TRUE(std::filesystem::exists(path)) << path;
  std::filesystem::remove_all(folder);
  const loading::Loaded haze = loading::load_text(
      "volume rock = level_set(sphere(1m), voxel: 20cm)\nlight l = sphere()\n"
      "medium air = haze(extinction: 0.1/m)\n",
      "t.vug", {});
  ASSERT_TRUE(haze.usable()) << haze.report();
  const shot::Shot other = with_meshes(haze.shot);
  building::Builder again(other);
  const std::vector<std::string> reported = export_set(again, folder, options).unsupported;
  EXPECT_NE(std::find(reported.begin(), reported.end(),
                      "the haze 'air', which fills all space and has no grid"),
            reported.end());
  std::filesystem::remove_all(folder);
}

constexpr const char* kCard = R"(
mesh blade { of leaf(length: 1m, width: 20cm, rows: 4, card: true) }
mesh plain { of leaf(length: 1m, width: 20cm, rows: 60) }
object cut on blade { material surface(thin: true, opacity: leaf_blade()) }
object veil on blade { material surface(thin: true, opacity: attribute(name: "leaf_along")) }
object pane on blade { material surface(thin: true, opacity: 0.25) }
object whole on plain { material surface(thin: true, color: (0.2, 0.4, 0.1), subsurface: 0.8, through: 0.25, through_color: (0.5, 1, 1)) }
)";

double area_of(const mesh::Mesh& mesh) {
  double area = 0;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto p = mesh::corners(mesh, i);
    area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).length();
  }
  return area;
}

TEST(Assemble, OpacityIsCutOutOrKept) {
  const Made made(kCard);
  const std::vector<exchange::Prototype>& parts = made.out.assembly.prototypes;
  ASSERT_EQ(parts.size(), 4u);
  const auto opacity = [](const exchange::Prototype& part) {
    return mesh::find_attribute(*part.mesh, "opacity", 1);
  };
  // The card is cut to the same leaf as the mesh of its outline; the stalk is slightly wider there.
  const exchange::Prototype& cut = parts[0];
  EXPECT_EQ(cut.look.opacity, 1);
  EXPECT_EQ(opacity(cut), nullptr);
  EXPECT_NEAR(area_of(*cut.mesh) / area_of(*parts[3].mesh), 1, 0.02);
  EXPECT_LT(cut.mesh->triangles.size(), 20000u);
  const auto* across = mesh::find_attribute(*cut.mesh, "leaf_across", 1);
  const auto* along = mesh::find_attribute(*cut.mesh, "leaf_along", 1);
  ASSERT_TRUE(across && along);
  const paint::LeafOutline outline;
  for (size_t v = 0; v < cut.mesh->positions.size(); ++v)
    EXPECT_LE(std::fabs(static_cast<double>(across->values[v])),
              outline.half_width(static_cast<double>(along->values[v])) + 0.01);
  // Partial opacity is kept.
  ASSERT_NE(opacity(parts[1]), nullptr);
  EXPECT_EQ(parts[1].mesh->triangles.size(), 16u);
  const auto* far = mesh::find_attribute(*parts[1].mesh, "leaf_along", 1);
  for (size_t v = 0; v < far->values.size(); ++v) {
    const float t = far->values[v];
    EXPECT_NEAR(opacity(parts[1])->values[v], t * t * (3 - 2 * t), 1e-6f);
  }
  EXPECT_EQ(parts[2].look.opacity, 0.25);
  // A thin sheet distributes its light to both sides.
  const exchange::Look& leaf = parts[3].look;
  EXPECT_NEAR(leaf.base_color.y, 0.4 * (1 - 0.8 * 0.25), 1e-6);
  EXPECT_NEAR(leaf.through.y, 0.4 * 0.8 * 0.25, 1e-6);
  EXPECT_NEAR(leaf.through.x, 0.5 * 0.2 * 0.8 * 0.25, 1e-6);
  EXPECT_EQ(opacity(parts[2]), nullptr);
}

TEST(Assemble, TheCameraOfTheFirstPictureComesFirst) {
  const Made made("camera a {}\ncamera b {}\ncamera c {}\nrender b { size 320x180 }\n");
  std::vector<std::string> names;
  for (const exchange::Camera& each : made.out.assembly.cameras) names.push_back(each.name);
  EXPECT_EQ(names, (std::vector<std::string>{"b", "a", "c"}));
  EXPECT_EQ(made.out.assembly.cameras[0].size, Vec2i(320, 180));
}

TEST(ExportSet, VolumesAreInTheProgramsSpace) {
  const Made made;
  const ScratchFolder scratch("vug_export_set");
  const std::filesystem::path& folder = scratch.path();
  for (const exchange::Program* program : exchange::programs()) {
    std::filesystem::remove_all(folder);
    ExportOptions options;
    options.program = program;
    building::Builder builder(made.shot);
    const exchange::WriteReport written = export_set(builder, folder, options);
    for (const auto& path : export_paths(made.shot, folder, options))
      EXPECT_TRUE(std::filesystem::exists(path)) << path;
    const volume::FileInfo info = volume::info(folder / "t_rock.vdb");
    ASSERT_EQ(info.grids.size(), 1u);
    EXPECT_EQ(info.grids[0].name, "surface");
    EXPECT_EQ(info.grids[0].grid_class, volume::GridClass::level_set);
    EXPECT_EQ(info.metadata.at("vug:metersPerUnit"),
              volume::MetaValue(program->space.metres_per_unit));
    EXPECT_EQ(info.metadata.at("vug:upAxis"),
              volume::MetaValue(exchange::to_string(program->space.up)));
    EXPECT_EQ(info.metadata.at("vug:recipe"), volume::MetaValue(std::string(kScene)));
    EXPECT_NEAR(info.grids[0].voxel_size.x * program->space.metres_per_unit, 0.1, 1e-9);
    const volume::FileInfo fog = volume::info(folder / "t_mist.vdb");
    EXPECT_EQ(fog.grids.at(0).name, "density");
    EXPECT_EQ(fog.grids.at(0).grid_class, volume::GridClass::fog);
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace vug::delivery
