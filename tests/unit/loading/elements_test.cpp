// SPDX-License-Identifier: Apache-2.0
// Declarations for each element of a list, of all keywords, and references to their elements.
#include <gtest/gtest.h>
#include <vug/loading/load.h>
#include <vug/scene/format.h>
#include <vug/scene/parser.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vug::loading {
namespace {

constexpr const char* kScene = R"(seed 4
let sizes = [1m, 2m, 3m]
let colours = [(0.2, 0.3, 0.4), (0.5, 0.4, 0.3), (0.1, 0.1, 0.1)]
field ball[size in sizes] = sphere(size * (0.9..1))
volume v[i in 0..2] = level_set(ball[i], voxel: sizes[i] / 10)
mesh m[i in 0..2] on v[i] { smallest_piece i * 10cm }
material stone[c in colours] = lambert(albedo: c)
cells worn[i in 0..1] on m[i] { spacing 50cm  run random_color }
object o[i in 0..2] on m[2 - i] { material stone[i] }
object spotted on worn[1] {}
place many[i in 0..1] { of [o[i], o[2]]  at (i * 9m, 0, 0) }
volume cloud[i in 1..2] = fog(sphere(i * 1m), voxel: 20cm)
medium smoke[i in 0..1] on cloud[i] { kind cloud }
light lamp[i in 0..3] = sphere(center: (i * 3m, 9m, 0), radius: 5cm)
camera cam[x in [20, 30]] { eye (x, 0, 5)  target (0, 0, 0) }
render r[i in 0..1] { camera cam[i]  spp 2 ^ i  lights [lamp[i], lamp[2]]  air smoke[i] }
)";

template <class All, class NameOf>
std::string names(const All& all, const NameOf& name_of) {
  std::vector<std::string> out;
  for (const auto& each : all) out.push_back(name_of(each));
  return fmt::format("{}", fmt::join(out, " "));
}

TEST(Elements, AllDeclarationsCanBeMadeForEach) {
  const Loaded scene = load_text(kScene, "t.vug");
  ASSERT_EQ(scene.report(), "");
  const shot::Shot& shot = scene.shot;
  const auto name = [](const auto& each) { return each.name; };
  const auto pointed = [](const auto& each) { return each->name; };
  const auto first = [](const auto& each) { return each.first; };
  EXPECT_EQ(names(shot.volumes, pointed), "v[0] v[1] v[2] cloud[0] cloud[1]");
  EXPECT_EQ(names(shot.meshes, pointed), "m[0] m[1] m[2] worn[0] worn[1]");
  EXPECT_EQ(names(shot.objects, name), "o[0] o[1] o[2] spotted");
  EXPECT_EQ(names(shot.instancers, name), "many[0] many[1]");
  EXPECT_EQ(names(shot.materials, first), "stone[0] stone[1] stone[2]");
  EXPECT_EQ(names(shot.media, name), "smoke[0] smoke[1]");
  EXPECT_EQ(names(shot.lights, first), "lamp[0] lamp[1] lamp[2] lamp[3]");
  EXPECT_EQ(names(shot.cameras, name), "cam[0] cam[1]");
  EXPECT_EQ(names(shot.renders, name), "r[0] r[1]");
}

TEST(Elements, ReferToElementsOfOthers) {
  const Loaded scene = load_text(kScene, "t.vug");
  ASSERT_EQ(scene.report(), "");
  const shot::Shot& shot = scene.shot;
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(shot.meshes[i]->volume, shot.volumes[i]);
    EXPECT_DOUBLE_EQ(shot.volumes[i]->voxel, 0.1 * static_cast<double>(i + 1));
    EXPECT_DOUBLE_EQ(shot.meshes[i]->smallest_piece, 0.1 * static_cast<double>(i));
    EXPECT_EQ(shot.objects[i].mesh, shot.meshes[2 - i]);
    EXPECT_EQ(shot.objects[i].material, shot.materials[i].second);
  }
  EXPECT_EQ(shot.objects[3].mesh, shot.meshes[4]);
  EXPECT_EQ(shot.instancers[1].of[0].name, "o[1]");
  EXPECT_EQ(shot.media[1].volume, shot.volumes[4]);
  EXPECT_EQ(shot.renders[1].settings.spp, 2);
  EXPECT_EQ(shot.renders[1].settings.lights, (std::vector<std::string>{"lamp[1]", "lamp[2]"}));
  EXPECT_EQ(shot.renders[1].settings.air, "smoke[1]");
  const auto made = scene.provenance.find("mesh", "m[2]");
  ASSERT_NE(made, nullptr);
  EXPECT_EQ(made->where.line, 6);
}

TEST(Elements, DrawNumbersOfTheirOwn) {
  const Loaded scene = load_text(
      "volume v[i in 0..1] = level_set(sphere(1m..2m), voxel: 10cm)\n"
      "volume w[i in 0..3] = level_set(sphere(1m..2m), voxel: 10cm)\n"
      "volume v0 = level_set(sphere(1m..2m), voxel: 10cm)\n",
      "t.vug");
  ASSERT_EQ(scene.report(), "");
  const auto radius = [&](size_t i) { return scene.shot.volumes[i]->field.bounds().max.x; };
  EXPECT_NE(radius(0), radius(1));
  EXPECT_NE(radius(0), radius(2));
}

TEST(Elements, NamesMayBeThoseOfOtherKindsAndLets) {
  const Loaded scene = load_text(
      "let rock = [sphere(1m), box((1, 3, 1))]\n"
      "volume rock[solid in rock] = level_set(solid, voxel: 20cm)\n"
      "mesh rock[i in 0..1] on rock[i] {}\n"
      "let stone = [0.5, 0.2]\n"
      "material stone[grey in stone] = lambert(albedo: (grey, grey, grey))\n"
      "object rock[i in 0..1] on rock[i] { material stone[i] }\n"
      "let cam = 2\ncamera cam[x in [2, 3]] { eye (x, 5, 5)  target (0, 0, 0) }\n"
      "render rock[i in 0..1] { camera cam[cam - 1]  objects rock[i] }\n",
      "t.vug");
  ASSERT_EQ(scene.report(), "");
  EXPECT_EQ(scene.shot.objects[1].mesh->volume, scene.shot.volumes[1]);
  EXPECT_EQ(scene.shot.renders[1].settings.objects, std::vector<std::string>{"rock[1]"});
}

TEST(Elements, DependenciesDoNotSeeTheVariables) {
  const Loaded scene = load_text(
      "mesh m[n in 0..1] on v[n] {}\nvolume v[i in 0..n] = level_set(sphere(1m), voxel: 10cm)\n",
      "t.vug");
  EXPECT_EQ(scene.diagnostics.all().at(0).message, "unknown name 'n'");
}

TEST(Elements, TogetherHaveTheLimitOfAnExpression) {
  const Loaded scene = load_text(
      "light lamp[i in 0..9999] = sphere(radius: sum([for k in 0..999: 1cm]), lumen: 1)\n",
      "t.vug");
  ASSERT_EQ(scene.diagnostics.all().empty(), false);
  EXPECT_EQ(scene.diagnostics.all().at(0).message, "this would take 10000000 loop iterations");
}

TEST(Elements, AreEvaluatedOncePerAnimationIfTheyAreStill) {
  StaticCache cache;
  LoadOptions options;
  options.static_cache = &cache;
  const std::string text =
      "volume v[i in 0..1] = level_set(sphere(1m + i * 1m), voxel: 10cm)\n"
      "volume w[i in 0..1] = level_set(sphere(1m + frame * 1m), voxel: 10cm)\n"
      "mesh m[i in 0..1] on v[i] {}\nmesh n[i in 0..1] on w[i] {}\n";
  const Loaded first = load_text(text, "t.vug", options);
  options.frame = 2;
  const Loaded second = load_text(text, "t.vug", options);
  ASSERT_EQ(first.report() + second.report(), "");
  ASSERT_EQ(second.shot.meshes.size(), 4u);
  EXPECT_EQ(first.shot.meshes[1], second.shot.meshes[1]);
  EXPECT_NE(first.shot.meshes[3], second.shot.meshes[3]);
  EXPECT_EQ(second.shot.meshes[3]->name, "n[1]");
}

TEST(Elements, KeepTheirMeaningWhenFormatted) {
  const auto dumped = [](const std::string& text) {
    Diagnostics diagnostics;
    const scene::Document document = scene::parse(text, "t.vug", diagnostics);
    EXPECT_FALSE(diagnostics.has_errors());
    return dump(document);
  };
  const std::string formatted = scene::format(kScene);
  EXPECT_EQ(dumped(formatted), dumped(kScene));
  EXPECT_EQ(scene::format(formatted), formatted);
  EXPECT_NE(formatted.find("mesh m[i in 0..2] on v[i] { smallest_piece i * 10cm }\n"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::loading
