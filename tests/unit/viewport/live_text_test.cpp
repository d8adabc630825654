// SPDX-License-Identifier: Apache-2.0
// Successive versions of a text: an error keeps the last version, and products are kept.
#include "scene.h"

namespace vug::viewport {
namespace {

std::shared_ptr<Progress> quiet() { return std::make_shared<Progress>(); }

TEST(LiveText, AnErrorKeepsTheLastVersion) {
  LiveText text("scene.vug", {});
  EXPECT_FALSE(text.has_version());
  ASSERT_TRUE(text.load(scene_text(), quiet()));
  const loading::Loaded* before = &text.loaded();
  EXPECT_FALSE(text.load(scene_text() + "object wrong on nowhere { }\n", quiet()));
  EXPECT_EQ(&text.loaded(), before);
  ASSERT_TRUE(text.problems().has_errors());
  EXPECT_EQ(text.problems().all().front().where.line, 16);
  EXPECT_NE(text.report().find("nowhere"), std::string::npos);
}

TEST(LiveText, ProductsThatAChangeDoesNotAffectAreKept) {
  LiveText text("scene.vug", {});
  ASSERT_TRUE(text.load(scene_text(), quiet()));
  build_preview(text, {});
  EXPECT_EQ(text.builder().counts().level_sets, 3u);
  ASSERT_TRUE(text.load("# a comment\n" + scene_text("60cm"), quiet()));
  build_preview(text, {});
  EXPECT_EQ(text.builder().counts().level_sets, 1u);
  EXPECT_GT(text.kept(), 0u);
}

TEST(LiveText, ChecksAddFaultsOfUsableTextsOnly) {
  LiveText text("scene.vug", {});
  const auto check = [](loading::Loaded& loaded) {
    loaded.diagnostics.warning({"scene.vug", 1, 1}, "a remark");
  };
  ASSERT_TRUE(text.load(scene_text(), quiet(), check));
  ASSERT_EQ(text.problems().all().size(), 1u);
  EXPECT_EQ(text.problems().all().front().message, "a remark");
  EXPECT_FALSE(text.load("volume", quiet(), check));
  for (const Diagnostic& each : text.problems().all()) EXPECT_NE(each.message, "a remark");
}

}  // namespace
}  // namespace vug::viewport
