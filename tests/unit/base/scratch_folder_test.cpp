// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace vug {
namespace {

TEST(ScratchFolder, IsRemovedWithItsContents) {
  std::filesystem::path first, second;
  {
    const ScratchFolder one("vug_scratch_test"), other("vug_scratch_test");
    first = one.path(), second = other.path();
    EXPECT_NE(first, second);
    EXPECT_EQ(first.filename().string().rfind("vug_scratch_test_", 0), 0u);
    write_text(one.file("deep") / "a.txt", "a");
    EXPECT_EQ(read_text(first / "deep" / "a.txt"), "a");
  }
  EXPECT_FALSE(std::filesystem::exists(first));
  EXPECT_FALSE(std::filesystem::exists(second));
}

TEST(ScratchFolder, ReportsFoldersThatCannotBeCreated) {
  try {
    const ScratchFolder none("no_such_folder/vug");
    FAIL() << "made " << none.path();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::io);
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace vug
