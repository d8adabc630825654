// SPDX-License-Identifier: Apache-2.0
// Changes of files are noticed however they are written, with and without events of the system.
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/watch/file_watcher.h>

#include <gtest/gtest.h>

#include <fstream>

namespace vug::watch {
namespace {

using std::chrono::milliseconds;
namespace fs = std::filesystem;

constexpr milliseconds kLong{20000}, kShort{30}, kQuiet{5};

class FileWatchers : public testing::TestWithParam<FileWatcher::Method> {
 protected:
  ScratchFolder folder_{"vug_watcher_test"};
  FileWatcher watcher_{GetParam()};
};

TEST_P(FileWatchers, NoticesEachWayToSave) {
  const fs::path file = folder_.file("scene.vug"), other = folder_.file("part.vug");
  write_text(file, "a");
  watcher_.watch({file, other});
  EXPECT_FALSE(watcher_.wait(kShort, kQuiet)) << "nothing has changed";

  std::ofstream(file) << "written in place";
  EXPECT_TRUE(watcher_.wait(kLong, kQuiet));
  EXPECT_FALSE(watcher_.wait(kShort, kQuiet)) << "each change is reported once";

  write_text(file, "replaced by rename");
  EXPECT_TRUE(watcher_.wait(kLong, kQuiet));

  write_text(other, "created");
  EXPECT_TRUE(watcher_.wait(kLong, kQuiet));

  fs::remove(other);
  EXPECT_TRUE(watcher_.wait(kLong, kQuiet));

  write_text(folder_.file("unrelated.txt"), "x");
  EXPECT_FALSE(watcher_.wait(kShort, kQuiet));
}

TEST_P(FileWatchers, ANewListKeepsUnreportedChanges) {
  const fs::path file = folder_.file("scene.vug"), other = folder_.file("part.vug");
  write_text(file, "a");
  watcher_.watch({file});
  write_text(file, "longer");
  watcher_.watch({file, other});
  EXPECT_TRUE(watcher_.wait(kLong, kQuiet));
  watcher_.watch({other});
  write_text(file, "no longer watched");
  EXPECT_FALSE(watcher_.wait(kShort, kQuiet));
}

INSTANTIATE_TEST_SUITE_P(Methods, FileWatchers,
                         testing::Values(FileWatcher::Method::events,
                                         FileWatcher::Method::polling));

}  // namespace
}  // namespace vug::watch
