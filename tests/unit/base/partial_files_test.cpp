// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/partial_files.h>
#include <vug/base/scratch_folder.h>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vug {
namespace {
namespace fs = std::filesystem;

/// The id of a process that has ended.
std::string a_dead_process() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return std::to_string(child);
}

TEST(PartialFiles, FindsFilesOfDeadProcesses) {
  const ScratchFolder scratch("vug_hidden_names");
  const fs::path& folder = scratch.path();
  const std::string dead = a_dead_process();
  const fs::path file = folder / (".a." + dead + ".part.exr"),
                 bare = folder / (".a." + dead + ".part");
  for (const fs::path& each :
       {file, bare, folder / partial_file_name("a", ".exr"), folder / (".b." + dead + ".part.exr"),
        folder / (".a.x" + dead + ".part.exr"), folder / (".a.-" + dead + ".part.exr"),
        folder / ".a..part.exr", folder / ".a.part.exr", folder / ".a.1.part.exr"})
    write_text(each, "");
  using Paths = std::vector<fs::path>;
  EXPECT_EQ(stale_partial_files(folder, "a", ".exr"), Paths{file});
  EXPECT_EQ(stale_partial_files(folder, "a"), Paths{bare});
  EXPECT_TRUE(stale_partial_files(folder / "none", "a").empty());
  EXPECT_EQ(partial_file_name("a", ".exr"), ".a." + std::to_string(getpid()) + ".part.exr");
}

TEST(PartialFiles, ReturnsCreatedFolders) {
  const ScratchFolder scratch("vug_hidden_folders");
  const fs::path& folder = scratch.path();
  EXPECT_TRUE(make_folders(folder).empty());
  EXPECT_TRUE(make_folders("").empty());
  const std::vector<fs::path> made = make_folders(folder / "a" / "b");
  EXPECT_EQ(made, (std::vector<fs::path>{folder / "a" / "b", folder / "a"}));
  write_text(folder / "a" / "file", "another's");
  remove_empty_folders(made);
  EXPECT_FALSE(fs::exists(folder / "a" / "b"));
  EXPECT_TRUE(fs::exists(folder / "a" / "file"));
}

TEST(PartialFiles, FailedCreationLeavesNoFolders) {
  const ScratchFolder scratch("vug_hidden_failure");
  const fs::path& folder = scratch.path();
  const fs::path deep = folder / "a" / std::string(300, 'x');
  try {
    make_folders(deep);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), "cannot create folder '" + deep.string() + "': File name too long");
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace vug
