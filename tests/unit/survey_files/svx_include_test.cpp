// SPDX-License-Identifier: Apache-2.0
#include "svx_text.h"

#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/survey_files/read_survey.h>

namespace vug::survey {
namespace {

class SvxInclude : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    write_text(scratch.file(name), text);
  }
  Survey read(const std::string& name, const ReadOptions& options = {}) {
    Diagnostics warnings;
    return read_survey(scratch.file(name), options, warnings);
  }
  void expect_fault(const std::string& name, const std::string& message, int line,
                    const ReadOptions& options = {}) {
    try {
      read(name, options);
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), message);
      EXPECT_EQ(error.where().line, line);
    }
  }

  ScratchFolder scratch{"vug_include"};
};

TEST_F(SvxInclude, FilesAreFoundAsSurvexFindsThem) {
  write("cave/all.svx",
        "*begin cave\n*include parts\\Upper\n*include \"parts/lower.svx\"\n*equate upper.2 "
        "lower.1\n*end cave\n");
  write("cave/parts/upper.svx",
        "*begin upper\n*export 2\n*include more/deep\n1 2 10 0 0\n*end upper\n");
  write("cave/parts/more/deep.svx", "*units tape feet\n");
  write("cave/parts/lower.svx", "*begin lower\n*export 1\n1 2 10 90 0\n*end lower\n");
  const Survey survey = read("cave/all.svx");
  // Settings of an included file last: feet in the survey that includes it, not after its end.
  expect_near(position_of(survey, "cave.lower.2"), {10, 3.048, 0}, 1e-9);
  EXPECT_EQ(survey.stations.back().where.file, scratch.file("cave/parts/lower.svx").string());
}

TEST_F(SvxInclude, FilesOutsideOfTheFolderAreRefused) {
  write("cave/a.svx", "1 2 3 4 5\n*include ../secret\n");
  write("secret.svx", "3 4 3 4 5\n");
  const std::string refused = "the file '../secret' is outside of the survey's folder";
  expect_fault("cave/a.svx", refused, 2);
  ReadOptions outside;
  outside.allow_outside = true;
  EXPECT_EQ(read("cave/a.svx", outside).stations.size(), 4U);
  ReadOptions root;
  root.root = scratch.path();
  EXPECT_EQ(read("cave/a.svx", root).stations.size(), 4U);

  // Absolute names, links, and missing files outside are refused in the same way.
  write("cave/b.svx", "*include " + scratch.file("secret.svx").string() + "\n");
  expect_fault(
      "cave/b.svx",
      "the file '" + scratch.file("secret.svx").string() + "' is outside of the survey's folder",
      1);
  std::filesystem::create_symlink(scratch.file("secret.svx"), scratch.file("cave/link.svx"));
  write("cave/c.svx", "*include link\n");
  expect_fault("cave/c.svx", "the file 'link' is outside of the survey's folder", 1);
  write("cave/d.svx", "*include ../missing\n");
  expect_fault("cave/d.svx", "the file '../missing' is outside of the survey's folder", 1);
}

TEST_F(SvxInclude, MissingFilesCyclesAndSizesAreErrors) {
  write("a.svx", "*include b\n");
  write("b.svx", "; a comment\n*include a.svx\n");
  write("c.svx", "\n\n  *include nothing ; not there\n");
  write("d.svx", "*begin x\n*include e\n*end x\n");
  write("e.svx", "*end x\n");
  write("f.svx", "*include g\n1 2 3 4 5\n");
  write("g.svx", "*begin y\n1 2 3 4 5\n");
  expect_fault("a.svx", "the file 'a.svx' includes itself", 2);
  expect_fault("c.svx", "cannot read the file 'nothing': no such file", 3);
  expect_fault("d.svx", "*end without *begin in this file", 1);
  expect_fault("f.svx", "*begin without *end in this file", 1);
  std::filesystem::create_directory(scratch.file("folder"));
  write("h.svx", "*include folder\n");
  expect_fault("h.svx", "cannot read the file 'folder': it is a folder", 1);
  ReadOptions small;
  small.max_bytes = 35;
  expect_fault("f.svx", "the files of the survey exceed 35 bytes", 1, small);
  small.max_bytes = 15;
  expect_fault("f.svx", "the files of the survey exceed 15 bytes", 1, small);
}

TEST_F(SvxInclude, HugeFilesAreNotRead) {
  // A file of 8 GiB without contents: reading it would take minutes.
  write("huge.svx", "1 2 3 4 5\n");
  std::filesystem::resize_file(scratch.file("huge.svx"), std::uintmax_t{1} << 33);
  write("a.svx", "\n*include huge\n");
  const std::string message = "the files of the survey exceed 1073741824 bytes";
  expect_fault("a.svx", message, 2);
  expect_fault("huge.svx", message, 1);
  std::filesystem::rename(scratch.file("huge.svx"), scratch.file("huge.3d"));
  expect_fault("huge.3d", message, 1);
}

}  // namespace
}  // namespace vug::survey
