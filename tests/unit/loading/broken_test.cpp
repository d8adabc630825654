// SPDX-License-Identifier: Apache-2.0
// Every scene in tests/data/broken/scenes is reported exactly as in its .expected file. These
// scenes parse but are invalid; tests/data/broken/syntax has scenes that do not parse. A first line
// "# run: -D NAME=EXPR" is an override. With VUG_UPDATE=1 in the environment the expected files are
// rewritten; review the difference before committing it.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/loading/load.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace vug::loading {
namespace {

namespace fs = std::filesystem;

fs::path folder() { return fs::path(VUG_TEST_DATA) / "broken" / "scenes"; }

std::vector<fs::path> broken_scenes() {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(folder()))
    if (entry.path().extension() == ".vug") all.push_back(entry.path().filename());
  std::sort(all.begin(), all.end());
  return all;
}

LoadOptions options_of(const std::string& text) {
  LoadOptions options;
  const std::string run = "# run: -D ";
  if (text.compare(0, run.size(), run) != 0) return options;
  const std::string given = text.substr(run.size(), text.find('\n') - run.size());
  options.overrides.push_back(
      {given.substr(0, given.find('=')), given.substr(given.find('=') + 1)});
  return options;
}

// One test for all of them, because each test is a process.
TEST(BrokenScenes, AreReportedAsExpected) {
  fs::current_path(folder());  // so that messages contain only the file name
  for (const fs::path& scene : broken_scenes()) {
    SCOPED_TRACE(scene.string());
    fs::path expected = scene;
    expected.replace_extension(".expected");
    const Loaded loaded = load(scene, options_of(read_text(scene)));
    EXPECT_FALSE(loaded.diagnostics.all().empty());
    if (std::getenv("VUG_UPDATE")) write_text(expected, loaded.report());
    EXPECT_EQ(loaded.report(), read_text(expected));
  }
}

}  // namespace
}  // namespace vug::loading
