// SPDX-License-Identifier: Apache-2.0
// Drafts: scenes whose meshes are not polished.
#include <vug/building/builder.h>
#include <vug/loading/load.h>

#include <gtest/gtest.h>

namespace vug::building {
namespace {

loading::Loaded draft_scene(const std::string& text, const loading::LoadOptions& options = {}) {
  loading::Loaded made = loading::load_text(text, "t.vug", options);
  EXPECT_EQ(made.report(), "");
  return made;
}

TEST(Drafts, HaveUnpolishedMeshes) {
  const std::string text = "volume rock = level_set(box(size: (1, 1, 1)) - sphere(60cm), voxel: ";
  loading::LoadOptions draft;
  draft.draft = true;
  const loading::Loaded quick = draft_scene(text + "10cm)\nmesh skin on rock {}", draft);
  const loading::Loaded plain = draft_scene(text + "10cm)\nmesh skin on rock { polish false }");
  const loading::Loaded final = draft_scene(text + "10cm)\nmesh skin on rock {}");
  Builder one(quick.shot), other(plain.shot), third(final.shot);
  EXPECT_EQ(*one.mesh(quick.shot.meshes.at(0)), *other.mesh(plain.shot.meshes.at(0)));
  EXPECT_FALSE(*one.mesh(quick.shot.meshes.at(0)) == *third.mesh(final.shot.meshes.at(0)));
  EXPECT_NE(quick.shot.recipe.find("# --quality draft\n"), std::string::npos);
  EXPECT_FALSE(quick.shot.text_digest == final.shot.text_digest) << "finished frames are redone";
}

}  // namespace
}  // namespace vug::building
