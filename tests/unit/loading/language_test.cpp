// SPDX-License-Identifier: Apache-2.0
// Every ```vug example in the documentation of the language, cells, groves, L-systems, facades,
// bamboo and the first cave is a valid scene, including names of kinds and parameters, which the
// parser does not check.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/building/flat_scene.h>
#include <vug/facade/tree.h>
#include <vug/loading/load.h>
#include <vug/lsystem/derive.h>
#include <vug/shot/cells_plan.h>
#include <vug/shot/lsystem_plan.h>

#include <algorithm>
#include <filesystem>

namespace vug::loading {
namespace {

namespace fs = std::filesystem;

/// The fenced code blocks of a page in `language`.
std::vector<std::string> blocks(const std::string& language,
                                const std::string& page = "reference/language.md") {
  const std::string text = read_text(fs::path(VUG_DATA).parent_path() / "docs" / page);
  std::vector<std::string> all;
  const std::string open = "```" + language + "\n", close = "```";
  for (size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    at += open.size();
    const size_t end = text.find(close, at);
    all.push_back(text.substr(at, end - at));
    at = end;
  }
  return all;
}

TEST(Language, ExamplesAreValid) {
  ASSERT_GE(blocks("vug").size(), 10u);
  LoadOptions options;
  options.include_folders = {fs::path(VUG_TEST_DATA) / "scenes" / "language", fs::path(VUG_DATA)};
  for (const std::string& example : blocks("vug")) {
    const Loaded loaded = load_text(example, "language.md", options);
    EXPECT_EQ(loaded.report(), "") << example;
  }
}

TEST(Language, DripsOfTheirPageAreValid) {
  const std::vector<std::string> examples = blocks("vug", "reference/drips.md");
  ASSERT_GE(examples.size(), 1u);
  LoadOptions options;
  options.include_folders = {fs::path(VUG_DATA)};
  for (const std::string& example : examples)
    EXPECT_EQ(load_text(example, "drips.md", options).report(), "") << example;
}

TEST(Language, EveryDecorationMakesRock) {
  size_t count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(VUG_DATA) / "decorations")) {
    ++count;
    LoadOptions options;
    options.include_folders = {fs::path(VUG_DATA)};
    const Loaded loaded = load_text(
        "include \"decorations/" + entry.path().filename().string() +
            "\" as decor\nlet bare = complement(box(size: (4, 3, 4)))\n"
            "volume rock = level_set(decor.decorate(bare, from: (-2, -1.5, -2), to: (2, 1.6, 2)),\n"
            "  voxel: 10cm, from: (-3, -2, -3), to: (3, 2, 3))\n",
        "decorated.vug", options);
    EXPECT_EQ(loaded.report(), "") << entry.path();
    ASSERT_EQ(loaded.shot.volumes.size(), 1u) << entry.path();
    const field::Field& rock = loaded.shot.volumes[0]->field;
    int grown = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3d p(-1.95 + 3.9 * (i % 20) / 19, -1.35 + 2.8 * (i / 20 % 10) / 9,
                    -1.95 + 3.9 * (i / 200) / 19);
      grown += rock.value(p) < 0;
    }
    EXPECT_GT(grown, 0) << entry.path() << ": nothing grew in the room";
    EXPECT_LT(grown, 2800) << entry.path() << ": the room is full";
  }
  EXPECT_GE(count, 9u);
}

TEST(Language, DecorationsOfTheirGuideAreValid) {
  LoadOptions options;
  options.include_folders = {fs::path(VUG_DATA)};
  for (const std::string& example : blocks("vug", "guides/decorating.md"))
    EXPECT_EQ(load_text(example, "decorating.md", options).report(), "") << example;
}

TEST(Language, NetworksOfTheirPageMakeSolids) {
  const std::vector<std::string> examples = blocks("vug", "reference/networks.md");
  ASSERT_GE(examples.size(), 2u);
  for (const std::string& example : examples) {
    // The files of the examples are those of the teaching scenes.
    const fs::path here = fs::path(VUG_DATA) / "scenes" / "teaching" / "networks.md";
    LoadOptions options;
    options.include_folders = {fs::path(VUG_DATA)};
    const Loaded loaded = load_text(example, here.string(), options);
    EXPECT_EQ(loaded.report(), "") << example;
    size_t declared = 0;
    for (size_t at = 0; (at = example.find("volume ", at)) != std::string::npos; ++at)
      declared += at == 0 || example[at - 1] == '\n';
    EXPECT_GE(declared, 1u) << example;
    EXPECT_EQ(loaded.shot.volumes.size(), declared) << example;
  }
}

TEST(Language, FacadesOfTheirPageDivide) {
  const std::vector<std::string> examples = blocks("vug", "reference/facades.md");
  ASSERT_GE(examples.size(), 2u);
  for (const std::string& example : examples) {
    const Loaded loaded = load_text(example, "facades.md");
    EXPECT_EQ(loaded.report(), "") << example;
    ASSERT_FALSE(loaded.shot.derivations.empty());
    EXPECT_GT(facade::element_instances(*loaded.shot.derivations[0].facade).size(), 4u) << example;
  }
}

TEST(Language, LSystemsOfTheirPageGrow) {
  const std::vector<std::string> examples = blocks("vug", "reference/lsystems.md");
  ASSERT_GE(examples.size(), 8u);
  for (const std::string& example : examples) {
    const Loaded loaded = load_text(example, "lsystems.md");
    EXPECT_EQ(loaded.report(), "") << example;
    ASSERT_FALSE(loaded.shot.lsystems.empty());
    const lsystem::System& system = *loaded.shot.lsystems.back()->system;
    EXPECT_GT(lsystem::interpret(system, lsystem::derive(system)).size(), 1u) << example;
  }
}

TEST(Language, PlantsOfTheBambooPageShow) {
  LoadOptions options;
  options.include_folders = {fs::path(VUG_DATA)};
  const std::vector<std::string> examples = blocks("vug", "guides/bamboo.md");
  ASSERT_GE(examples.size(), 3u);
  for (const std::string& example : examples) {
    const Loaded loaded = load_text(example, "bamboo.md", options);
    ASSERT_EQ(loaded.report(), "") << example;
    building::Builder builder(loaded.shot);
    EXPECT_FALSE(building::flatten_scene(builder).objects.empty()) << example;
  }
}

TEST(Language, CellsOfTheirPageAreOnAMesh) {
  const std::vector<std::string> examples = blocks("vug", "reference/cells.md");
  ASSERT_FALSE(examples.empty());
  for (const std::string& example : examples)
    EXPECT_EQ(load_text(example, "cells.md").report(), "") << example;
  const Loaded loaded = load_text(examples[0], "cells.vug");
  ASSERT_EQ(loaded.shot.objects.size(), 1u);
  const shot::MeshPlan& mesh = *loaded.shot.objects[0].mesh;
  ASSERT_TRUE(mesh.cells);
  EXPECT_EQ(mesh.name, "crust");
  EXPECT_EQ(mesh.cells->on.at(0)->name, "wall");
  EXPECT_EQ(mesh.cells->run.size(), 4u);
  EXPECT_EQ(mesh.cells->run[0]->span(), 1);
  EXPECT_EQ(mesh.cells->run[1]->span(), -1);
  EXPECT_EQ(mesh.cells->length(), 130);
}

TEST(Language, PlantsOfTheGrovesPageStandOnTheirGround) {
  const std::vector<std::string> examples = blocks("vug", "guides/groves.md");
  ASSERT_GE(examples.size(), 2u);
  LoadOptions options;
  options.include_folders = {fs::path(VUG_DATA)};
  for (const std::string& example : examples)
    EXPECT_EQ(load_text(example, "groves.md", options).report(), "") << example;
  const Loaded loaded = load_text(examples[0], "groves.md", options);
  building::Builder builder(loaded.shot);
  EXPECT_GT(building::flatten_scene(builder).objects.size(), 100u);
}

TEST(Language, TheFirstSceneIsTenLinesThatMakeAPicture) {
  const std::vector<std::string> examples = blocks("vug", "tutorials/first_cave.md");
  ASSERT_EQ(examples.size(), 5u);
  EXPECT_EQ(std::count(examples[0].begin(), examples[0].end(), '\n'), 10);
  for (const char* size : {"2.5m", "4m"}) {
    LoadOptions options;
    options.overrides = {{"SIZE", size}};
    const Loaded loaded = load_text(examples[0], "first.vug", options);
    EXPECT_EQ(loaded.report(), "");
    ASSERT_EQ(loaded.shot.volumes.size(), 1u);
    ASSERT_EQ(loaded.shot.cameras.size(), 1u);
    EXPECT_EQ(loaded.shot.renders.size(), 1u);
    EXPECT_EQ(loaded.shot.lights.size(), 2u);
    // The camera is in the hall, not in rock.
    const Vec3f eye = loaded.shot.cameras[0].camera->position();
    EXPECT_GT(loaded.shot.volumes[0]->field.value(Vec3d(eye)), 0) << size;
  }
}

TEST(Language, TheTutorialBuildsTheSceneOfAnOwnCave) {
  const std::vector<std::string> examples = blocks("vug", "tutorials/first_cave.md");
  ASSERT_EQ(examples.size(), 5u);
  std::string built;
  for (size_t i = 1; i < examples.size(); ++i) built += (i > 1 ? "\n" : "") + examples[i];
  const std::string scene = read_text(fs::path(VUG_DATA) / "scenes/teaching/own_cave.vug");
  EXPECT_EQ(built, scene.substr(scene.find("seed")));
  LoadOptions options;
  options.include_folders = {fs::path(VUG_DATA)};
  EXPECT_EQ(load_text(built, "my_cave.vug", options).report(), "");
}

TEST(Language, TheTutorialOfSurveysBuildsItsScene) {
  const std::vector<std::string> examples = blocks("vug", "tutorials/your_survey.md");
  ASSERT_EQ(examples.size(), 2u);
  const fs::path folder = fs::path(VUG_DATA) / "scenes/teaching";
  LoadOptions options;
  options.include_folders = {fs::path(VUG_DATA)};
  for (const std::string& example : examples)
    EXPECT_EQ(load_text(example, (folder / "creek.vug").string(), options).report(), "");
  const std::string scene = read_text(folder / "survey.vug");
  EXPECT_EQ(examples[1], scene.substr(scene.find("param")));
}

TEST(Language, TheFaultOfTheTutorialIsReportedAsShown) {
  std::string shown;
  for (const std::string& block : blocks("text"))
    if (shown.empty() && block.find("error: ") != std::string::npos) shown = block;
  const size_t line = shown.find('\n') + 1;
  const std::string faulty = shown.substr(line, shown.find('\n', line) + 1 - line);
  const Loaded loaded = load_text("let radius = 1m\n\n\n" + faulty, "cave.vug");
  EXPECT_EQ(loaded.report(), shown);
}

}  // namespace
}  // namespace vug::loading
