// SPDX-License-Identifier: Apache-2.0
// Variants of a loaded scene.
#include <gtest/gtest.h>
#include <vug/loading/load.h>

namespace vug::loading {
namespace {

constexpr const char* kStone = R"(
param SIZE = 1m  in 10cm..3m
param NAME = "a"
volume rock = level_set(sphere(SIZE), voxel: 10cm)
volume ball = level_set(if(NAME == "a", sphere(1m), sphere(2m)), voxel: 10cm)
material large = lambert()
mesh skin on rock {}
object stone on skin { material large }
variant large { SIZE max(2m,  # the larger one
                         1m)  NAME "b # c" }
variant moving { SIZE keys(1: 1m, 9: 2m) }
)";

Loaded stone(const std::string& variant, std::vector<scene::Override> overrides = {}) {
  LoadOptions options;
  options.variant = variant;
  options.overrides = std::move(overrides);
  return load_text(kStone, "t.vug", options);
}

TEST(LoadedVariants, ChangeTheScene) {
  const Loaded plain = stone(""), large = stone("large");
  ASSERT_EQ(plain.report(), "");
  ASSERT_EQ(large.report(), "");
  EXPECT_EQ(plain.shot.volumes[0]->field.bounds().max.x, 1);
  EXPECT_EQ(large.shot.volumes[0]->field.bounds().max.x, 2);
  EXPECT_EQ(stone("large", {{"SIZE", "3"}}).shot.volumes[0]->field.bounds().max.x, 3);
}

TEST(LoadedVariants, AreListedWithTheirValues) {
  const Loaded loaded = stone("");
  ASSERT_EQ(loaded.variants.size(), 2u);
  EXPECT_EQ(loaded.variants[0].name, "large");
  ASSERT_EQ(loaded.variants[0].values.size(), 2u);
  EXPECT_EQ(to_string(loaded.variants[0].values[0].second), "2m");
  EXPECT_EQ(loaded.variants[0].where.line, 9);
}

TEST(LoadedVariants, AVariantThatIsNotChosenDoesNotAnimateTheScene) {
  EXPECT_FALSE(stone("").shot.animated);
  EXPECT_TRUE(stone("moving").shot.animated);
}

TEST(LoadedVariants, RecipesContainTheirValues) {
  const std::string recipe = stone("large").shot.recipe;
  EXPECT_NE(
      recipe.find("\n# -D SIZE=max(2m,                            1m)\n# -D NAME=\"b # c\"\n"),
      std::string::npos)
      << recipe;
  const std::string given = stone("large", {{"SIZE", "3"}}).shot.recipe;
  EXPECT_NE(given.find("\n# -D SIZE=3\n# -D NAME=\"b # c\"\n"), std::string::npos) << given;
}

}  // namespace
}  // namespace vug::loading
