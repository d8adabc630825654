// SPDX-License-Identifier: Apache-2.0
// The cache of declarations across versions of a text: values whose text is the same are the
// identical objects, and the shot is that of a new evaluation.
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/loading/load.h>
#include <vug/shot/cells_plan.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::loading {
namespace {

const std::string kTwoRocks = R"(param size = 1 in 0.1..5
let ball = sphere(radius: size)
def lifted(s, by = 1) = s.translate((0, by, 0))
volume rock = level_set(lifted(ball), voxel: 10cm)
mesh rock on rock { polish false }
material stone = lambert(albedo: (0.5, 0.5, 0.5))
object rock on rock { material stone }
volume floor = level_set(box(size: (4, 0.2, 4)), voxel: 10cm)
mesh floor on floor { }
object floor on floor { material stone }
light lamp[x in [1, 2]] = sphere(center: (x, 2, 0), radius: 10cm)
camera main { eye (0, 1, 5) target (0, 0, 0) }
render main { size 32x18 spp 2 camera main }
)";

/// A text of which versions are loaded with one cache.
class Versions {
 public:
  Loaded load(const std::string& text) {
    LoadOptions options;
    options.static_cache = &cache_;
    return load_text(text, "scene.vug", options);
  }
  size_t reused() const { return cache_.reused; }

 private:
  StaticCache cache_;
};

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(DeclarationCache, AChangeKeepsWhatDoesNotUseIt) {
  Versions versions;
  const Loaded first = versions.load(kTwoRocks);
  ASSERT_TRUE(first.usable()) << first.report();
  EXPECT_EQ(versions.reused(), 0u);

  const Loaded same = versions.load(kTwoRocks);
  EXPECT_EQ(same.shot.volumes, first.shot.volumes);
  EXPECT_EQ(same.shot.lights, first.shot.lights);

  const Loaded lamp =
      versions.load(changed(kTwoRocks, "2, 0), radius: 10cm", "2, 0), radius: 20cm"));
  EXPECT_EQ(lamp.shot.volumes, first.shot.volumes);
  EXPECT_EQ(lamp.shot.objects[0].mesh, first.shot.objects[0].mesh);
  EXPECT_EQ(lamp.shot.objects[0].material, first.shot.objects[0].material);
  EXPECT_EQ(lamp.shot.cameras[0].camera, first.shot.cameras[0].camera);
  EXPECT_NE(lamp.shot.lights[0].second, first.shot.lights[0].second);

  const Loaded stone = versions.load(changed(kTwoRocks, "(0.5, 0.5, 0.5)", "(0.2, 0.5, 0.5)"));
  EXPECT_EQ(stone.shot.volumes, first.shot.volumes);
  EXPECT_EQ(stone.shot.objects[0].mesh, first.shot.objects[0].mesh);
  EXPECT_NE(stone.shot.objects[0].material, first.shot.objects[0].material);
  EXPECT_EQ(stone.shot.objects[0].material, stone.shot.objects[1].material);
}

/// Through a parameter, a let and a function.
TEST(DeclarationCache, AChangeReachesWhatUsesIt) {
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"size = 1 ", "size = 2 "}, {"radius: size", "radius: size * 2"}, {"by = 1)", "by = 2)"}};
  for (const auto& [from, to] : changes) {
    Versions versions;
    const Loaded first = versions.load(kTwoRocks);
    const Loaded next = versions.load(changed(kTwoRocks, from, to));
    EXPECT_NE(next.shot.volumes[0], first.shot.volumes[0]) << to;
    EXPECT_NE(next.shot.objects[0].mesh, first.shot.objects[0].mesh) << to;
    EXPECT_EQ(next.shot.volumes[1], first.shot.volumes[1]) << to;
    EXPECT_EQ(next.shot.objects[1].mesh, first.shot.objects[1].mesh) << to;
  }
}

TEST(DeclarationCache, CommentsAndNewLinesMoveTheLocations) {
  Versions versions;
  const Loaded first = versions.load(kTwoRocks);
  const Loaded moved = versions.load(
      "# a comment\n\n" + changed(kTwoRocks, "{ polish false }", "{ polish false }  # rough"));
  EXPECT_EQ(moved.shot.volumes, first.shot.volumes);
  EXPECT_EQ(moved.shot.meshes, first.shot.meshes);
  EXPECT_EQ(moved.shot.lights, first.shot.lights);
  const Loaded fresh = load_text("# a comment\n\n" + kTwoRocks, "scene.vug");
  EXPECT_EQ(moved.shot.volumes[1]->where, fresh.shot.volumes[1]->where);
  EXPECT_EQ(moved.shot.objects[0].where, fresh.shot.objects[0].where);
  EXPECT_EQ(moved.shot.cameras[0].where, fresh.shot.cameras[0].where);
}

/// A volume moves with its own declaration, and not again with the mesh on it.
TEST(DeclarationCache, SharedPlansMoveOnce) {
  for (size_t lines = 1; lines < 12; ++lines) {
    Versions versions;
    versions.load(kTwoRocks);
    const std::string text = std::string(lines, '\n') + kTwoRocks;
    const Loaded moved = versions.load(text), fresh = load_text(text, "scene.vug");
    EXPECT_GT(versions.reused(), 0u);
    ASSERT_EQ(moved.shot.volumes.size(), fresh.shot.volumes.size());
    for (size_t i = 0; i < fresh.shot.volumes.size(); ++i)
      EXPECT_EQ(moved.shot.volumes[i]->where, fresh.shot.volumes[i]->where) << lines;
  }
}

TEST(DeclarationCache, OrderAndNamesAreThoseOfANewEvaluation) {
  Versions versions;
  versions.load(kTwoRocks);
  // The object precedes its mesh, which it evaluates.
  std::string text =
      changed(kTwoRocks, "volume floor", "object first on rock { material stone }\nvolume floor");
  text = changed(text, "mesh rock on rock { polish false }\n", "") +
         "mesh rock on rock { polish false }\n";
  for (const std::string& version : {text, kTwoRocks, text}) {
    const Loaded kept = versions.load(version), fresh = load_text(version, "scene.vug");
    ASSERT_EQ(kept.shot.objects.size(), fresh.shot.objects.size());
    for (size_t i = 0; i < fresh.shot.objects.size(); ++i)
      EXPECT_EQ(kept.shot.objects[i].name, fresh.shot.objects[i].name);
    for (size_t i = 0; i < fresh.shot.volumes.size(); ++i)
      EXPECT_EQ(kept.shot.volumes[i]->name, fresh.shot.volumes[i]->name);
    for (size_t i = 0; i < fresh.shot.lights.size(); ++i)
      EXPECT_EQ(kept.shot.lights[i].first, fresh.shot.lights[i].first);
    EXPECT_EQ(kept.shot.text_digest, fresh.shot.text_digest);
    EXPECT_EQ(kept.shot.recipe, fresh.shot.recipe);
  }
}

/// A text with an error keeps the values for the next one, and a value that has been replaced
/// meanwhile does not return with its old user.
TEST(DeclarationCache, SurvivesErrors) {
  Versions versions;
  const Loaded first = versions.load(kTwoRocks);
  EXPECT_FALSE(
      versions.load(changed(kTwoRocks, "object floor on floor", "object floor on flooring"))
          .usable());
  EXPECT_EQ(versions.load(kTwoRocks).shot.volumes, first.shot.volumes);

  const std::string other = changed(kTwoRocks, "(0.5, 0.5, 0.5)", "(0.2, 0.5, 0.5)");
  EXPECT_FALSE(versions.load(changed(other, "object rock on rock", "object rock on rok")).usable());
  const Loaded back = versions.load(other);
  ASSERT_TRUE(back.usable());
  EXPECT_EQ(back.shot.objects[0].material, back.shot.materials[0].second);
}

TEST(DeclarationCache, FilesCount) {
  const ScratchFolder folder("vug_cache_test");
  const std::string mesh =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  write_text(folder.file("a.obj"), mesh);
  const std::string text =
      "mesh part { file \"a.obj\" }\nmesh other { file \"a.obj\" }\nobject part on part { "
      "}\nobject other on other { }\n";
  const std::string name = folder.file("scene.vug").string();
  StaticCache cache;
  LoadOptions options;
  options.static_cache = &cache;
  const Loaded first = load_text(text, name, options);
  ASSERT_TRUE(first.usable()) << first.report();
  EXPECT_EQ(load_text(text, name, options).shot.meshes, first.shot.meshes);
  write_text(folder.file("a.obj"), mesh + "# longer\n");
  const Loaded next = load_text(text, name, options);
  for (const shot::MeshPtr& each : next.shot.meshes)
    EXPECT_EQ(std::count(first.shot.meshes.begin(), first.shot.meshes.end(), each), 0);
}

/// `place` is taken only from an equal text, to which the placed file belongs.
TEST(DeclarationCache, PlacedScenesCount) {
  const ScratchFolder folder("vug_cache_test");
  const auto write_post = [&](const std::string& height) {
    write_text(folder.file("post.vug"), "volume post = level_set(box(size: (0.2, " + height +
                                            ", 0.2)), voxel: 10cm)\nmesh post on post { }\n"
                                            "object post on post { }\n");
  };
  const std::string text = "place posts { of scene(\"post.vug\") at [(0, 0, 0), (2, 0, 0)] }\n";
  const std::string name = folder.file("scene.vug").string();
  StaticCache cache;
  LoadOptions options;
  options.static_cache = &cache;
  write_post("1");
  const Loaded first = load_text(text, name, options);
  ASSERT_TRUE(first.usable()) << first.report();
  EXPECT_EQ(load_text(text, name, options).shot.text_digest, first.shot.text_digest);
  EXPECT_GT(cache.reused, 0u);
  write_post("1.25");
  const Loaded next = load_text(text, name, options);
  EXPECT_EQ(cache.reused, 0u);
  EXPECT_FALSE(next.shot.text_digest == first.shot.text_digest);
}

}  // namespace
}  // namespace vug::loading
