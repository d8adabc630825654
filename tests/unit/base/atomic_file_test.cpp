#include <vug/base/atomic_file.h>
#include <vug/base/error.h>

#include <gtest/gtest.h>

namespace vug {
namespace {
namespace fs = std::filesystem;

TEST(AtomicFile, LeavesTheOldFileUntilCommit) {
  const fs::path folder = fs::path(testing::TempDir()) / "vug_atomic";
  fs::remove_all(folder);
  write_text(folder / "a.txt", "old");
  {
    AtomicFile file(folder / "a.txt");
    write_text(file.path(), "new, but abandoned");
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  write_text(folder / "a.txt", "new");
  EXPECT_EQ(read_text(folder / "a.txt"), "new");
}

TEST(AtomicFile, SaysWhatCannotBeRead) {
  try {
    read_text("/nowhere/at/all.vug");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "cannot read '/nowhere/at/all.vug': no such file");
  }
}

}  // namespace
}  // namespace vug
