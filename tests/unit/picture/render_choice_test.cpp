// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/loading/load.h>
#include <vug/picture/render_choice.h>

namespace vug::picture {
namespace {

using Names = std::vector<std::string>;

constexpr const char* kTwo = R"(
camera main { eye (0, 1, 5) }
camera top  { kind orthographic  eye (0, 9, 0)  target (0, 0, 0)  up (0, 0, -1)  width 9m }
render main { size 640x360 }
render plan { camera top  size 300x200 }
)";

Names chosen(const std::string& text, const Names& wanted) {
  const loading::Loaded loaded = loading::load_text(text, "t.vug");
  EXPECT_EQ(loaded.report(), "");
  return choose_renders(loaded.shot, wanted);
}

/// The message and the hint.
std::string fault(const std::string& text, const Names& wanted) {
  try {
    chosen(text, wanted);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    return std::string(error.what()) + " / " + error.hint();
  }
}

TEST(RenderChoice, BlocksOfIncludedFilesDoNotCountNextToOwnOnes) {
  loading::LoadOptions options;
  options.include_folders = {VUG_DATA};
  const auto loaded = loading::load_text(
      "include \"scenes/teaching/skylight.vug\"\nrender other {}\n", "t.vug", options);
  ASSERT_EQ(loaded.report(), "");
  ASSERT_EQ(loaded.shot.renders.size(), 2u);
  EXPECT_EQ(choose_renders(loaded.shot, {}), Names{"other"});
  EXPECT_EQ(choose_renders(loaded.shot, {"all"}), Names{"other"});
  EXPECT_EQ(choose_renders(loaded.shot, {"main"}), Names{"main"});
  const auto only =
      loading::load_text("include \"scenes/teaching/skylight.vug\"\n", "t.vug", options);
  EXPECT_EQ(choose_renders(only.shot, {}), Names{"main"});
}

TEST(RenderChoice, TakesTheOnlyBlock) {
  EXPECT_EQ(chosen("", {}), Names{""});
  EXPECT_EQ(chosen("", {"all"}), Names{""});
  EXPECT_EQ(chosen("render still {}", {}), Names{"still"});
}

TEST(RenderChoice, TakesNamedBlocksInTheirOrder) {
  EXPECT_EQ(chosen(kTwo, {"plan"}), Names{"plan"});
  EXPECT_EQ(chosen(kTwo, {"plan", "main", "plan"}), (Names{"plan", "main"}));
  EXPECT_EQ(chosen(kTwo, {"all"}), (Names{"main", "plan"}));
}

TEST(RenderChoice, SeveralBlocksNeedAChoice) {
  EXPECT_EQ(fault(kTwo, {}),
            "the scene has 2 renders, and none is chosen / write --render NAME or --render all; "
            "its renders: main (camera 'main', 640x360), plan (camera 'top', 300x200)");
  EXPECT_EQ(fault(kTwo, {"plam"}), "the scene has no render 'plam' / did you mean 'plan'?");
  EXPECT_EQ(fault(kTwo, {"main", "x"}), "the scene has no render 'x' / known: main, plan");
}

TEST(RenderChoice, FilesAreNamedAfterTheBlock) {
  const auto path = [](const char* file) { return path_of_render(file, "plan").string(); };
  EXPECT_EQ(path("out/cave.exr"), "out/cave_plan.exr");
  EXPECT_EQ(path("cave.####.exr"), "cave_plan.####.exr");
  EXPECT_EQ(path("cave_%04d.exr"), "cave_plan_%04d.exr");
  EXPECT_EQ(path("cave%d.exr"), "cave_plan%d.exr");
  EXPECT_EQ(path("####.exr"), "plan_####.exr");
  EXPECT_EQ(path("50%d/wood.exr"), "50%d/wood_plan.exr");
}

}  // namespace
}  // namespace vug::picture
