#include <vug/base/atomic_file.h>
#include <vug/base/error.h>

#include <gtest/gtest.h>
#include <sys/stat.h>

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

/// None of these ends, or they end the program; so nothing but a regular file is opened.
TEST(ReadText, RefusesWhatIsNoRegularFile) {
  const fs::path folder = fs::path(testing::TempDir()) / "vug_no_file";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto refusal = [](const fs::path& path) {
    try {
      read_text(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_input);
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal(pipe), "cannot read '" + pipe.string() + "': it is a pipe");
  EXPECT_EQ(refusal(folder), "cannot read '" + folder.string() + "': it is a folder");
  EXPECT_EQ(refusal("/dev/zero"), "cannot read '/dev/zero': it is a device");
  EXPECT_EQ(refusal("/proc/self/mem").find("cannot read '/proc/self/mem': "), 0u);
}

}  // namespace
}  // namespace vug
