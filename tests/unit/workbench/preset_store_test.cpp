// SPDX-License-Identifier: Apache-2.0
// Presets: kept in a file, shared by stores, locked.
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/workbench/preset_store.h>

#include <gtest/gtest.h>

namespace vug::workbench {
namespace {

TEST(PresetStore, KeepsValuesInAFile) {
  const ScratchFolder folder("vug_presets");
  PresetStore store(folder.path(), "/scenes/cave.vug");
  EXPECT_TRUE(store.all().empty());
  const Preset wide{"very wide", false, {{"WIDTH", "3m"}, {"NAME", "\"a # b\""}, {"N", "2 * M"}}};
  store.save(wide);
  store.save({"low", false, {}});
  const PresetStore other(folder.path(), "/scenes/../scenes/cave.vug");
  ASSERT_EQ(other.all().size(), 2u);
  EXPECT_EQ(other.all()[0].name, "low");
  EXPECT_EQ(other.find("very wide").values, wide.values);
  EXPECT_TRUE(PresetStore(folder.path(), "/scenes/other.vug").all().empty());
  EXPECT_THROW(other.find("very"), Error);
}

TEST(PresetStore, LockedOnesCannotBeReplacedOrDeleted) {
  const ScratchFolder folder("vug_presets");
  PresetStore store(folder.path(), "/scenes/cave.vug");
  store.save({"wide", false, {{"WIDTH", "3m"}}});
  store.lock("wide", true);
  EXPECT_THROW(store.save({"wide", false, {{"WIDTH", "4m"}}}), Error);
  EXPECT_THROW(store.remove("wide"), Error);
  EXPECT_EQ(store.find("wide").values[0].second, "3m");
  store.lock("wide", false);
  store.save({"wide", false, {{"WIDTH", "4m"}}});
  EXPECT_EQ(store.find("wide").values[0].second, "4m");
  store.remove("wide");
  EXPECT_TRUE(store.all().empty());
  EXPECT_THROW(store.save({"", false, {}}), Error);
}

}  // namespace
}  // namespace vug::workbench
