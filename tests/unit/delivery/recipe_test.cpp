// SPDX-License-Identifier: Apache-2.0
#include <vug/delivery/recipe.h>
#include <vug/loading/load.h>

#include <gtest/gtest.h>

namespace vug::delivery {
namespace {

constexpr const char* kText = R"(# A cave.
seed 2012 + 1
param R = 1m   in 50cm..2m  "how wide"
param Q = (1 + 2)
  * 0.25
param S = min(R,
  2m)
param F = 10deg
  in 5deg..20deg
let a = R
volume rock = level_set(sphere(R) + box(size: (Q, S, 1)), voxel: 20cm)
field other = sphere(1m).rotate(axis: (0, 1, 0), angle: F))";

loading::LoadOptions changed() {
  loading::LoadOptions options;
  options.overrides = {{"R", "80cm"}, {"Q", "(2 - 1)"}, {"S", "1m + 10cm"}, {"F", "12deg"}};
  options.seed = 9;
  return options;
}

TEST(Recipe, OverridesAreInsertedIntoTheText) {
  const Recipe recipe = parse_recipe(std::string(kText) +
                                     "\n# -D R=80cm\n# -D Q=(2 - 1)\n# -D S=1m + 10cm\n"
                                     "# -D F=12deg\n# --seed 9\n");
  EXPECT_TRUE(recipe.arguments.empty());
  for (const char* line :
       {"\nseed 9\n", "param R = 80cm   in 50cm..2m  \"how wide\"\n", "param Q = (2 - 1)\n",
        "param S = 1m + 10cm\n", "param F = 12deg\n  in 5deg..20deg\n"})
    EXPECT_NE(recipe.scene.find(line), std::string::npos) << line << "in\n" << recipe.scene;
  EXPECT_EQ(recipe.scene.find("# -D"), std::string::npos);
}

TEST(Recipe, AnUnchangedTextStays) {
  for (const std::string text : {"", "seed 3\n# a remark\n", "volume a = level_set(sphere(1m))"}) {
    const Recipe recipe = parse_recipe(text);
    EXPECT_EQ(recipe.scene, text);
    EXPECT_TRUE(recipe.arguments.empty());
  }
}

TEST(Recipe, ASeedThatTheTextLacksIsAdded) {
  EXPECT_EQ(parse_recipe("let a = 1\n# --seed 5\n").scene, "let a = 1\nseed 5\n");
}

TEST(Recipe, OtherSettingsBecomeArguments) {
  const Recipe recipe =
      parse_recipe("include \"x.vug\"\n# -D HERE=2\n# --frame 12\n# --quality draft\n");
  EXPECT_EQ(recipe.scene, "include \"x.vug\"\n");
  EXPECT_EQ(recipe.arguments,
            (std::vector<std::string>{"-D HERE=2", "--frame 12", "--quality draft"}));
}

TEST(Recipe, ValuesOfModulesAreInsertedIntoTheirBlock) {
  const auto scene_of = [](const std::string& text) {
    const Recipe recipe = parse_recipe(text);
    EXPECT_TRUE(recipe.arguments.empty());
    return recipe.scene;
  };
  EXPECT_EQ(scene_of("include \"a.vug\" as a { x 4cm + 1cm  y (1, 2) }\n# -D a.y=(3, 4)\n"
                     "# -D a.x=7cm\n"),
            "include \"a.vug\" as a { x 7cm  y (3, 4) }\n");
  EXPECT_EQ(scene_of("include \"a.vug\" as a\n{\n  x [1,\n 2]\n}\n# -D a.z=1\n"),
            "include \"a.vug\" as a\n{ z 1 \n  x [1,\n 2]\n}\n");
  EXPECT_EQ(scene_of("include \"b.vug\" as b; include \"a.vug\" as a\n# -D a.x=1\n"),
            "include \"b.vug\" as b; include \"a.vug\" as a { x 1 }\n");
  EXPECT_EQ(parse_recipe("include \"a.vug\"\n# -D a.x=1\n").arguments,
            std::vector<std::string>{"-D a.x=1"});
}

TEST(Recipe, LoadsAsTheOriginal) {
  const std::string text = std::string(kText) + "\n";
  const loading::Loaded before = loading::load_text(text, "t.vug", changed());
  ASSERT_TRUE(before.usable()) << before.report();
  const Recipe recipe = parse_recipe(before.shot.recipe);
  const loading::Loaded after = loading::load_text(recipe.scene, "t.vug", {});
  ASSERT_TRUE(after.usable()) << after.report();
  EXPECT_EQ(after.shot.seed, 9u);
  EXPECT_EQ(after.shot.volumes.at(0)->field.bounds().max.x,
            before.shot.volumes.at(0)->field.bounds().max.x);
  EXPECT_EQ(parse_recipe(after.shot.recipe).scene, recipe.scene);
}

}  // namespace
}  // namespace vug::delivery
