// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/memory.h>

#include <gtest/gtest.h>

#include <vector>

namespace vug {
namespace {

TEST(Memory, ParsesAmounts) {
  EXPECT_EQ(parse_bytes("8G"), uint64_t{8} << 30);
  EXPECT_EQ(parse_bytes("512MiB"), uint64_t{512} << 20);
  EXPECT_EQ(parse_bytes("1.5k"), 1536u);
  for (const char* bad : {"", "G", "-1G", "8X", "nan", "8 apples", "1e30G"})
    EXPECT_THROW(parse_bytes(bad), Error) << bad;
}

TEST(Memory, RejectsExcessWithBothAmounts) {
  EXPECT_NO_THROW(require_memory(10, 20, "it"));
  try {
    require_memory(3.0 * (1 << 30), 1 << 30, "the level set 'rock'");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(
        error.what(),
        "the level set 'rock' would take about 3 GiB of memory, more than the limit of 1 GiB");
    EXPECT_EQ(error.hint(), "use a larger voxel, a smaller region, or raise --max-memory");
  }
  try {
    require_memory(20, 10, "the picture", "use fewer pixels");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.hint(), "use fewer pixels, or raise --max-memory");
  }
}

TEST(Memory, ResidentMemoryGrowsWithTouchedPages) {
  const uint64_t before = resident_memory();
  EXPECT_GT(before, 1u << 20);
  const std::vector<char> more(64u << 20, 'x');
  EXPECT_GT(resident_memory(), before + (60u << 20));
  EXPECT_EQ(more.back(), 'x');
}

}  // namespace
}  // namespace vug
