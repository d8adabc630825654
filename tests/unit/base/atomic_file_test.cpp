// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sstream>

namespace vug {
namespace {
namespace fs = std::filesystem;

TEST(AtomicFile, LeavesTheOldFileUntilCommit) {
  const ScratchFolder scratch("vug_atomic");
  const fs::path& folder = scratch.path();
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

mode_t mode_of(const fs::path& path) {
  struct stat status = {};
  EXPECT_EQ(stat(path.c_str(), &status), 0);
  return status.st_mode & 07777;
}

TEST(AtomicFile, KeepsLinksAndPermissions) {
  const ScratchFolder scratch("vug_links");
  const fs::path& folder = scratch.path();
  write_text(folder / "real" / "a.txt", "old");
  fs::create_symlink("real/a.txt", folder / "link.txt");
  fs::create_symlink(folder / "link.txt", folder / "link_of_link.txt");
  fs::create_symlink("real/new.txt", folder / "ahead.txt");
  for (const mode_t mode : {0640u, 0750u, 0444u}) {
    ASSERT_EQ(chmod((folder / "real" / "a.txt").c_str(), mode), 0);
    write_text(folder / "link_of_link.txt", "new");
    EXPECT_EQ(mode_of(folder / "real" / "a.txt"), mode);
  }
  write_text(folder / "ahead.txt", "made");
  for (const char* link : {"link.txt", "link_of_link.txt", "ahead.txt"})
    EXPECT_TRUE(fs::is_symlink(folder / link)) << link;
  EXPECT_EQ(read_text(folder / "real" / "a.txt"), "new");
  EXPECT_EQ(read_text(folder / "real" / "new.txt"), "made");
}

/// Creates a file as left by a process that was killed while writing.
fs::path make_stale_partial_file(const fs::path& target) {
  const pid_t child = fork();
  if (child == 0) {
    new AtomicFile(target);
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  std::ostringstream name;
  name << '.' << target.stem().string() << '.' << child << ".part" << target.extension().string();
  return target.parent_path() / name.str();
}

TEST(AtomicFile, RemovesStalePartialFiles) {
  const ScratchFolder scratch("vug_left");
  const fs::path& folder = scratch.path();
  const fs::path stale = make_stale_partial_file(folder / "a.exr"),
                 png = make_stale_partial_file(folder / "a.png"),
                 other = make_stale_partial_file(folder / "b.exr");
  for (const fs::path& file : {stale, png, other}) ASSERT_TRUE(fs::exists(file)) << file;
  // Its process may run on another machine, as its lock shows.
  const int held = open(stale.c_str(), O_RDONLY);
  ASSERT_EQ(flock(held, LOCK_EX | LOCK_NB), 0);
  require_writable(folder / "a.exr");
  EXPECT_TRUE(fs::exists(stale));
  close(held);
  require_writable(folder / "a.exr");
  for (const fs::path& file : {png, other}) EXPECT_TRUE(fs::exists(file)) << file;
  EXPECT_FALSE(fs::exists(stale));
}

std::string refusal_to_write(const fs::path& path, ErrorCode code = ErrorCode::io) {
  try {
    require_writable(path);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    return error.what();
  }
  return "";
}

TEST(AtomicFile, ReportsUnwritableTargetsBeforeTheWork) {
  const ScratchFolder scratch("vug_writable");
  const fs::path& folder = scratch.path();
  write_text(folder / "file", "a file");
  EXPECT_EQ(refusal_to_write(folder / "file" / "a.txt"),
            "cannot create folder '" + (folder / "file").string() + "': Not a directory");
  EXPECT_EQ(refusal_to_write(folder, ErrorCode::bad_input),
            "cannot write '" + folder.string() + "': it is a folder");
  const std::string deep = (folder / "new" / "er" / std::string(300, 'x')).string();
  EXPECT_EQ(refusal_to_write(deep), "cannot write '" + deep + "': File name too long");
  EXPECT_EQ(refusal_to_write("/proc/vug.txt").find("cannot write '/proc/vug.txt': "), 0u);
  EXPECT_EQ(refusal_to_write(folder / "new" / "er" / "a.txt"), "");
  EXPECT_EQ(refusal_to_write(folder / "file"), "");
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder), {}), 1);  // nothing is left
  EXPECT_EQ(read_text(folder / "file"), "a file");
}

TEST(AtomicFile, ReportsUnreadableFiles) {
  try {
    read_text("/nowhere/at/all.vug");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "cannot read '/nowhere/at/all.vug': no such file");
  }
}

/// Opening these would block or end the program, so only regular files are opened.
TEST(ReadText, RejectsSpecialFiles) {
  const ScratchFolder scratch("vug_no_file");
  const fs::path& folder = scratch.path();
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
