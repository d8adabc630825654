// SPDX-License-Identifier: Apache-2.0
// Micro-displacement of the objects of a picture.
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/loading/load.h>
#include <vug/mesh/topology.h>
#include <vug/picture/picture.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampling.h>

#include <algorithm>
#include <cmath>

namespace vug::picture {
namespace {

/// A rough cave in a block of rock, with cameras inside.
std::string cave(const std::string& detail, const std::string& more = "") {
  return "let air = displace(sphere(1m), noise: fbm(scale: 25cm, octaves: 4), amount: 3cm)\n"
         "volume rock = level_set(box(size: (3, 3, 3)) - air, voxel: 12cm)\n"
         "mesh wall on rock {}\n"
         "object cave on wall { detail " +
         detail +
         " }\n"
         "camera main { eye (0, 0, 0.3)  target (0, 0, -1) }\n"
         "camera other { eye (0.4, 0, 0)  target (1, 0, 0) }\n"
         "render main { size 64x48 }\n" +
         more;
}

loading::Loaded loaded_cave(const std::string& text) {
  loading::Loaded loaded = loading::load_text(text, "t.vug");
  EXPECT_EQ(loaded.report(), "");
  return loaded;
}

/// The mesh of the first object in a picture.
mesh::MeshPtr pictured(const std::string& text, const PictureOptions& options = {},
                       building::BuildOptions build = {}) {
  const loading::Loaded loaded = loaded_cave(text);
  building::Builder builder(loaded.shot, build);
  return prepare_picture(builder, plan_picture(loaded.shot, options), false)
      .scene.objects.at(0)
      .mesh;
}

const std::string kDice = "dice(pixels: 1, least: 5mm)";

PictureOptions with(const NamedValues& settings, const std::string& camera = "", int eye = 0) {
  PictureOptions options;
  options.settings = settings;
  options.camera = camera;
  options.eye = eye;
  return options;
}

TEST(Dicing, PartsOfAPictureHaveTheMeshOfTheWhole) {
  const mesh::MeshPtr whole = pictured(cave(kDice));
  const mesh::MeshPtr part = pictured(cave(kDice), with({{"crop", List{3, 4, 20, 30}}}));
  EXPECT_TRUE(*whole == *part);
  const mesh::MeshPtr larger = pictured(cave(kDice), with({{"size", List{96, 72}}}));
  EXPECT_GT(larger->triangles.size(), whole->triangles.size());
}

TEST(Dicing, ACameraOfItsOwnFreezesTheMesh) {
  const std::string frozen = cave("dice(pixels: 1, least: 5mm, camera: main)");
  EXPECT_TRUE(*pictured(frozen, with({}, "main")) == *pictured(frozen, with({}, "other")));
  EXPECT_FALSE(*pictured(cave(kDice), with({}, "main")) ==
               *pictured(cave(kDice), with({}, "other")));
}

TEST(Dicing, BothEyesSeeTheSameMesh) {
  const std::string stereo =
      cave(kDice, "camera both { eye (0, 0, 0.3)  target (0, 0, -1)  interaxial 20cm }\n");
  EXPECT_TRUE(*pictured(stereo, with({}, "both", -1)) == *pictured(stereo, with({}, "both", 1)));
}

TEST(Dicing, TheMeshStaysClosedAndDraftsAreNotDiced) {
  const mesh::MeshPtr diced = pictured(cave(kDice));
  const mesh::Topology topology = mesh::inspect(*diced);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.misoriented_edges, 0U);
  const loading::Loaded loaded = loaded_cave(cave(kDice));
  building::Builder builder(loaded.shot);
  const size_t plain = builder.mesh(loaded.shot.meshes.at(0))->triangles.size();
  EXPECT_GT(diced->triangles.size(), 10 * plain);
  shot::Shot draft = loaded.shot;
  draft.draft = true;
  building::Builder quick(draft);
  const PictureJob job = prepare_picture(quick, plan_picture(draft), false);
  EXPECT_LE(job.scene.objects.at(0).mesh->triangles.size(), plain);
}

// From inside, every ray hits the cave's wall, even if it is aimed at vertices and edges.
TEST(Dicing, NoRayLeavesASealedCave) {
  const loading::Loaded loaded = loaded_cave(cave(kDice));
  building::Builder builder(loaded.shot);
  const PictureJob job = prepare_picture(builder, plan_picture(loaded.shot), false);
  const render::PreparedScene world(job.scene);
  const mesh::Mesh& mesh = *job.scene.objects.at(0).mesh;
  size_t rays = 0;
  const auto expect_hit = [&](const Vec3f& eye, const Vec3f& target) {
    const Vec3f way = target - eye;
    if (target.length() > 1.3f || !(way.length() > 1e-4f)) return;  // the outside of the block
    render::Hit hit;
    ASSERT_TRUE(world.intersect({eye, way.normalized()}, hit));
    ASSERT_LT((eye + way.normalized() * hit.distance).length(), 1.3f);
    ++rays;
  };
  RandomStream random(RandomKey(9));
  for (const mesh::Triangle& t : mesh.triangles) {
    const auto uniform = [&] { return static_cast<float>(random.uniform()); };
    const Vec3f eye((uniform() - 0.5f) * 0.6f, (uniform() - 0.5f) * 0.6f,
                    (uniform() - 0.5f) * 0.6f);
    for (size_t k = 0; k < 3; ++k) {
      const Vec3f &a = mesh.positions[t[k]], &b = mesh.positions[t[(k + 1) % 3]];
      expect_hit(eye, a);
      expect_hit(eye, a + (b - a) * uniform());
    }
  }
  EXPECT_GT(rays, 100000U);
}

TEST(Dicing, SmallMemoryIsRefusedWithARateThatFits) {
  const std::string fine = cave("dice(pixels: 0.1, least: 1mm)");
  building::BuildOptions build;
  build.max_memory = uint64_t{64} << 20;
  try {
    pictured(fine, {}, build);
    FAIL() << "a mesh of many millions of triangles was diced";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
    EXPECT_NE(error.hint().find("detail dice(pixels: "), std::string::npos) << error.hint();
    EXPECT_EQ(error.where().line, 4);
    const std::string rate = error.hint().substr(error.hint().find("pixels: ") + 8);
    const std::string fitting = "dice(least: 1mm, pixels: " + rate.substr(0, rate.find(')')) + ")";
    EXPECT_GT(pictured(cave(fitting), {}, build)->triangles.size(), 10000U);
  }
}

TEST(Dicing, UnreachableDetailIsReported) {
  const loading::Loaded loaded =
      loaded_cave(cave("dice(pixels: 2, least: 2cm, field: sphere(9m))"));
  building::BuildOptions build;
  std::string report;
  build.on_warning = [&](const Diagnostics& found) { report += loaded.report(found); };
  building::Builder builder(loaded.shot, build);
  prepare_picture(builder, plan_picture(loaded.shot), false);
  EXPECT_NE(report.find("could not follow its detail"), std::string::npos) << report;
}

// On the faces of a region, the field has no gradient at some points.
TEST(Dicing, TheFacesOfARegionAreFollowed) {
  const loading::Loaded loaded = loaded_cave(
      "volume rock = level_set(sphere(1m), voxel: 10cm, from: (-0.5, -0.6, -2), to: (0.5, 2, 2))\n"
      "mesh skin on rock {}\nobject stone on skin { detail dice(edge: 2cm) }\n");
  building::BuildOptions build;
  std::string report;
  build.on_warning = [&](const Diagnostics& found) { report += loaded.report(found); };
  building::Builder builder(loaded.shot, build);
  const PictureJob job = prepare_picture(builder, plan_picture(loaded.shot), false);
  EXPECT_EQ(report, "");
  EXPECT_TRUE(mesh::inspect(*job.scene.objects.at(0).mesh).closed());
}

TEST(Dicing, MistakesAreErrors) {
  const auto report = [](const std::string& object) {
    return loading::load_text(
               "volume v = level_set(sphere(1m), voxel: 20cm)\nmesh m on v {}\n"
               "volume copy on m { voxel 20cm }\nmesh c on copy {}\n" +
                   object,
               "t.vug")
        .report();
  };
  EXPECT_NE(report("object o on m { direct true  detail dice() }\n").find("'direct' and 'detail'"),
            std::string::npos);
  EXPECT_NE(report("object o on c { detail dice() }\n").find("is not made from a field"),
            std::string::npos);
  EXPECT_EQ(report("object o on c { detail dice(field: sphere(1m)) }\n"), "");
  EXPECT_NE(
      report("object o on m { detail dice(edge: 1mm, least: 2mm) }\n").find("'edge' is shorter"),
      std::string::npos);
}

}  // namespace
}  // namespace vug::picture
