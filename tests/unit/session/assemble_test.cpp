// Scenes as plain data for other programs.
#include <vug/base/error.h>
#include <vug/session/assemble.h>
#include <vug/session/export_set.h>
#include <vug/session/load.h>
#include <vug/volume/io.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::session {
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
  Loaded loaded;
  Shot shot;
  Assembled out;

  explicit Made(const std::string& text = kScene) {
    loaded = load_text(text, "t.vug", {});
    EXPECT_EQ(loaded.report(), "");
    shot = with_meshes(loaded.shot);
    Builder builder(shot);
    out = assemble(builder);
  }
};

TEST(Assemble, WhatAShotShows) {
  const Made made;
  const exchange::Assembly& all = made.out.assembly;
  ASSERT_EQ(all.parts.size(), 2u);
  ASSERT_EQ(all.groups.size(), 2u);
  EXPECT_EQ(all.groups[0].name, "wall");
  EXPECT_EQ(all.groups[1].name, "heap");
  EXPECT_EQ(all.groups[1].places.size(), 2u);
  EXPECT_EQ(all.groups[1].places[1].origin(), Vec3d(4, 0, 0));
  ASSERT_EQ(all.cameras.size(), 1u);
  EXPECT_EQ(all.cameras[0].aspect, 3);
  ASSERT_EQ(all.lamps.size(), 1u);
  EXPECT_EQ(all.lamps[0].name, "ball");
  EXPECT_NEAR(exchange::luminance(exchange::power(all.lamps[0])), 100, 1e-3);
  EXPECT_EQ(all.provenance.recipe, kScene);
  EXPECT_EQ(all.provenance.seed, 5u);
  ASSERT_EQ(made.out.left_out.size(), 1u);
  EXPECT_NE(made.out.left_out[0].find("round"), std::string::npos);
}

TEST(Assemble, LooksAreBakedAtTheVertices) {
  const Made made;
  const exchange::Part& wall = made.out.assembly.parts[0];
  const mesh::Attribute* color = mesh::find_attribute(*wall.mesh, "Cd", 3);
  const mesh::Attribute* wet = mesh::find_attribute(*wall.mesh, "wetness", 1);
  ASSERT_TRUE(color && wet);
  // Nothing else of the look varies.
  EXPECT_EQ(wall.mesh->attributes.size(), 2u);
  EXPECT_NEAR(wall.look.roughness, 0.6, 1e-6);
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  for (size_t v = 0; v < wall.mesh->positions.size(); ++v) {
    const auto y = static_cast<double>(wall.mesh->positions[v].y);
    const double t = smooth(std::clamp((y + 0.4) / 0.8, 0.0, 1.0));
    EXPECT_NEAR(static_cast<double>(wet->values[v]), t, 1e-5);
    // The paint times the material's colour.
    EXPECT_NEAR(static_cast<double>(color->values[3 * v]), 0.5 * (0.5 + t * (0.1 - 0.5)), 1e-5);
  }
}

TEST(Assemble, WhatShinesSaysSo) {
  const Made made;
  const exchange::Part& glow = made.out.assembly.parts[1];
  EXPECT_LT((glow.look.emission - Vec3d(2, 1, 0.5)).length(), 1e-6);
  EXPECT_TRUE(glow.mesh->attributes.empty());
  EXPECT_EQ(glow.look.base_color, Vec3d(0.5));
}

TEST(ExportSet, AirIsCalledAir) {
  const Loaded scene = load_text(
      "let room = sphere(1m)\nvolume rock = level_set(box(size: (3, 3, 3)) - room, voxel: 20cm)\n"
      "volume air = level_set(room, voxel: 20cm)\n",
      "t.vug", {});
  ASSERT_TRUE(scene.usable()) << scene.report();
  const std::filesystem::path folder = testing::TempDir() + "vug_export_air";
  ExportOptions options;
  options.program = exchange::programs().front();
  const Shot shot = with_meshes(scene.shot);
  Builder builder(shot);
  export_set(builder, folder, options);
  EXPECT_EQ(volume::info(folder / "t_air.vdb").grids.at(0).name, "air");
  EXPECT_EQ(volume::info(folder / "t_rock.vdb").grids.at(0).name, "surface");
}

TEST(ExportSet, VolumesStandInTheProgramsSpace) {
  const Made made;
  const std::filesystem::path folder = testing::TempDir() + "vug_export_set";
  for (const exchange::Program* program : exchange::programs()) {
    std::filesystem::remove_all(folder);
    ExportOptions options;
    options.program = program;
    Builder builder(made.shot);
    const exchange::Written written = export_set(builder, folder, options);
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
}  // namespace vug::session
