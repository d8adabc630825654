// SPDX-License-Identifier: Apache-2.0
// Functions, loops and modules with the kinds of scenes: declarations for each element, names that
// several kinds share, and names of declarations that a let has as well.
#include <gtest/gtest.h>
#include <vug/loading/load.h>

namespace vug::loading {
namespace {

Loaded composed(const std::string& text) {
  LoadOptions options;
  options.include_folders = {VUG_DATA};
  return load_text(text, "t.vug", options);
}

std::string problems(const std::string& text) {
  const Loaded scene = composed(text);
  std::string out;
  for (const Diagnostic& one : scene.diagnostics.all()) out += one.message + ";";
  return out;
}

const std::string kRockScene =
    "volume rock = level_set(sphere(1m), voxel: 20cm)\nmesh skin on rock {}\nobject it on skin "
    "{}\n";

TEST(Composition, DeclaresLightsPlacesAndCamerasForEachElement) {
  const Loaded scene =
      composed(kRockScene +
               "let spots = [for i in 0..3 if i != 1: (i * 3m, 5m, 0)]\n"
               "light lamp[p in spots] = sphere(center: p, radius: 5cm, lumen: 300)\n"
               "place stone[i in 0..1] { of it  at (i * 4m, 0, 0) }\n"
               "camera view[x, y in [[0, 1], [9, 2]]] { eye (x, y, 8)  target (4, 1, 0) }\n"
               "render main { camera view[1] }\n");
  ASSERT_EQ(scene.report(), "");
  ASSERT_EQ(scene.shot.lights.size(), 3u);
  EXPECT_EQ(scene.shot.lights[2].first, "lamp[2]");
  ASSERT_EQ(scene.shot.instancers.size(), 2u);
  EXPECT_EQ(scene.shot.instancers[1].name, "stone[1]");
  ASSERT_EQ(scene.shot.cameras.size(), 2u);
  EXPECT_EQ(scene.shot.cameras[0].name, "view[0]");
  ASSERT_NE(scene.provenance.find("light", "lamp[2]"), nullptr);
  EXPECT_EQ(scene.provenance.find("light", "lamp[2]")->where.line, 5);
}

TEST(Composition, GrammarsDoNotSeeTheVariablesOfALoop) {
  EXPECT_NE(
      composed(
          "light lamp[r in [1m, 2m]] = sphere(radius: r, center: (0, at_height, 0), lumen: 9)\n"
          "let at_height = hidden(g)\n"
          "def hidden(field) = 0\n"
          "grammar g {\n  axiom A\n  A -> + sphere(r)\n}\n"
          "volume v = level_set(g, voxel: 20cm)\n")
          .report()
          .find("'radius' expects a number, not the name 'r'"),
      std::string::npos);
}

TEST(Composition, TheExpectedTypeChoosesAmongKindsOfOneName) {
  const Loaded scene =
      composed(kRockScene +
               "def lantern(at, power) = sphere(center: at, radius: 5cm, lumen: power)\n"
               "def bare() = sphere(radius: 5cm)\n"
               "let other = sphere(radius: 5cm, lumen: 20)\n"
               "light a = if(true, lantern((0, 3m, 0), 20), lantern((0, 4m, 0), 20))\n"
               "light b = bare()\n"
               "light c = other\n"
               "volume v = level_set(bare(), voxel: 1cm)\n");
  ASSERT_EQ(scene.report(), "");
  EXPECT_EQ(scene.shot.lights.size(), 3u);
}

TEST(Composition, DeclarationsAndLetsMayShareNames) {
  const Loaded scene = composed(
      "let rock = sphere(1m)\n"
      "volume rock = level_set(rock + box((1, 3, 1)), voxel: 20cm)\n"
      "mesh rock on rock {}\n"
      "let stone = (0.5, 0.4, 0.3)\n"
      "material stone = lambert(albedo: stone)\n"
      "object rock on rock { material stone }\n"
      "object second on rock { material mix(a: stone, b: lambert(albedo: stone * 0.5), mask: 0.5) "
      "}\n"
      "place many { of second  at scatter(on: rock, spacing: 50cm) }\n");
  EXPECT_EQ(scene.report(), "");
  EXPECT_EQ(scene.shot.objects.size(), 2u);
}

TEST(Composition, RulesHaveLocalNames) {
  const auto tree = [](const std::string& rule) {
    return composed("seed 5\ngrammar g {\n  axiom A*3\n  " + rule +
                    "\n}\n"
                    "volume v = level_set(g, voxel: 20cm)\n");
  };
  // Two boxes that touch only if both use the same draw.
  EXPECT_EQ(tree("A -> + box((r, r, r)) + box((r, r, r)) label +X where r = 0.5..1").report(), "");
  EXPECT_EQ(tree("A -> + sphere(r)\n      where r = 1m, s = t").report(), "");
  EXPECT_NE(tree("A -> + sphere(r) where r = r").report().find("'r' depends on itself"),
            std::string::npos);
}

TEST(Composition, ListsTheFunctionsThatTheTextCanCall) {
  const Loaded scene = composed(
      "include \"kit/rocks.vug\" as rocks\n"
      "def ring(count \"number of stones\", radius = 2m) \"Points on a circle.\" = [for i in "
      "1..count: (radius, 0, 0)]\n");
  std::string names;
  for (const KindInfo& each : scene.functions) names += each.name + ";";
  EXPECT_EQ(names, "rocks.slab;rocks.rubble;ring;");
  ASSERT_EQ(scene.functions.size(), 3u);
  EXPECT_EQ(scene.functions[2].doc, "Points on a circle.");
  ASSERT_EQ(scene.functions[2].params.size(), 2u);
  EXPECT_EQ(scene.functions[2].params[0].doc, "number of stones");
  EXPECT_TRUE(scene.functions[2].params[0].required);
  EXPECT_FALSE(scene.functions[2].params[1].required);
}

std::string appended(const std::vector<std::string>& texts, const std::string& expression) {
  LoadOptions options;
  options.appended = texts;
  options.expression = expression;
  const Loaded scene = load_text("let a = 2m\ndef twice(x) = 2 * x", "f/t.vug", options);
  return scene.usable() ? to_string(scene.value) : scene.report();
}

TEST(Composition, EvaluatesExpressionsWithAppendedStatements) {
  EXPECT_EQ(appended({}, "twice(a)"), "4m");
  EXPECT_EQ(appended({"let b = twice(a)", "let c = b + a"}, "[b, c]"), "[4m, 6m]");
  EXPECT_EQ(appended({}, "+X"), "+X");
  EXPECT_EQ(appended({"let bend = 1"}, "bent"),
            "expression:1:1: error: unknown name 'bent'\nbent\n^~~~\nhint: did you mean 'bend'?\n");
  EXPECT_EQ(appended({"let b = 1", "let b = 2"}, "b").substr(0, 18), "f/appended 2:1:5: ");
  EXPECT_EQ(joined_text("let a = 1", {"let b = 2\n", "let c = 3"}),
            "let a = 1\nlet b = 2\nlet c = 3\n");
  EXPECT_EQ(joined_text("let a = 1", {}), "let a = 1");
}

TEST(Composition, LibrariesHaveFunctions) {
  EXPECT_EQ(
      problems("include \"kit/rocks.vug\" as rocks { edge 4cm }\n"
               "volume v = level_set(rocks.rubble([for i in 0..3: (i * 1m, 0, 0)]), voxel: 5cm)\n"),
      "");
}

}  // namespace
}  // namespace vug::loading
