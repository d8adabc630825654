// SPDX-License-Identifier: Apache-2.0
// Where a choice is expected, its word means the choice even if the text declares something of that
// name.
#include <gtest/gtest.h>
#include <vug/loading/load.h>

namespace vug::loading {
namespace {

std::string faults(const std::string& text) { return load_text(text, "t.vug").report(); }

const std::string kRock = "volume rock = level_set(sphere(1m), voxel: 10cm)\n";

TEST(Choice, WinsInABlock) {
  const Loaded loaded = load_text(
      "field obj = box()\nvolume rock = level_set(obj, voxel: 10cm)\n"
      "mesh wall on rock { format obj }\n",
      "t.vug");
  EXPECT_EQ(loaded.report(), "");
  EXPECT_EQ(loaded.shot.meshes.at(0)->format, "obj");
}

TEST(Choice, WinsInsideTheDeclarationOfItsName) {
  EXPECT_EQ(faults(kRock + "mesh ply on rock { format ply }\n"), "");
  EXPECT_EQ(faults("camera perspective { kind perspective  eye (0, 0, 9) }\n"), "");
}

TEST(Choice, WinsInACall) {
  const auto rough = [](const std::string& noise) {
    return faults("let cracks = 3\nlet used = cracks\nfield wall = displace(sphere(1m), noise: " +
                  noise + ", amount: 1cm)\n");
  };
  EXPECT_EQ(rough("worley(pattern: cracks)"), "");
  EXPECT_EQ(rough("worley(cracks)"), "");
  EXPECT_NE(rough("worley(pattern: used)"), "");
}

TEST(Choice, WinsAmongTheClausesOfAGrammar) {
  const std::string grammar =
      "grammar g {\n  axiom A*2\n  A -> + sphere(1m) label +X reach whole\n"
      "  A @ 1 -> + box() label random\n}\n";
  EXPECT_EQ(faults("param X = 3\nparam random = 4\nparam whole = 5\n"
                   "let used = X + random + whole\n" +
                   grammar),
            "");
}

TEST(Choice, OtherNamesAreLookedUp) {
  EXPECT_EQ(
      faults("let kind_of_file = stl\n" + kRock + "mesh wall on rock { format kind_of_file }\n"),
      "");
  EXPECT_NE(faults("field pile = box()\n" + kRock + "mesh wall on rock { format pile }\n"), "");
}

}  // namespace
}  // namespace vug::loading
