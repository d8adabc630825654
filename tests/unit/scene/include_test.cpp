// SPDX-License-Identifier: Apache-2.0
// Includes of files below the data folders.
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>

#include "parsing.h"

namespace vug::scene {
namespace {

namespace fs = std::filesystem;

class IncludeBelow : public testing::Test {
 protected:
  IncludeBelow() : data_("include") {
    add("materials/limestone.vug", "let lime = 1");
    add("materials/old/slate.vug", "let slate = 1");
    add("looks/studio.vug", "let studio = 1");
    add("sets/studio.vug", "let studio = 2");
    options_.include_folders = {data_.file("")};
  }
  void add(const std::string& name, const std::string& text) {
    fs::create_directories(data_.file(name).parent_path());
    write_text(data_.file(name), text);
  }
  Document parse_text(const std::string& text) {
    return parse(text, data_.file("own/t.vug").string(), diagnostics_, options_);
  }
  /// The message and the hint of the only error.
  std::string fault(const std::string& text) {
    diagnostics_ = {};
    parse_text(text);
    if (diagnostics_.all().size() != 1) return "not one error";
    return diagnostics_.all()[0].message + " / " + diagnostics_.all()[0].hint;
  }

  ScratchFolder data_;
  ParseOptions options_;
  Diagnostics diagnostics_;
};

TEST_F(IncludeBelow, TakesTheOnlyFileOfThatName) {
  const Document document = parse_text(
      "include \"limestone.vug\"\ninclude \"old/slate.vug\"\nlet a = lime + slate\n"
      "include \"materials/limestone.vug\"");  // the same file: included once
  EXPECT_EQ(report(diagnostics_, document.sources), "");
  EXPECT_EQ(document.lets.size(), 3u);
}

TEST_F(IncludeBelow, TheFirstFolderWithTheFileCounts) {
  options_.include_folders = {data_.file("looks"), data_.file("")};
  const Document document = parse_text("include \"studio.vug\"");
  EXPECT_EQ(report(diagnostics_, document.sources), "");
  options_.include_folders = {data_.file("materials"), data_.file("sets"), data_.file("")};
  EXPECT_EQ(fault("include \"studio.vug\""), "not one error");
}

TEST_F(IncludeBelow, SeveralFilesAreAnErrorThatListsThem) {
  EXPECT_EQ(fault("include \"studio.vug\""),
            "'studio.vug' is the name of 2 files / include one of: \"looks/studio.vug\", "
            "\"sets/studio.vug\"");
}

TEST_F(IncludeBelow, AnotherFolderIsAHint) {
  EXPECT_EQ(fault("include \"rocks/limestone.vug\""),
            "cannot find the file 'rocks/limestone.vug' / did you mean "
            "'materials/limestone.vug'?");
}

TEST_F(IncludeBelow, OtherNamesAreNotFound) {
  const std::string looked = fault("include \"stone.vug\"");
  EXPECT_EQ(looked.rfind("cannot find the file 'stone.vug' / looked in ", 0), 0u) << looked;
}

TEST_F(IncludeBelow, CyclesAreErrors) {
  add("sets/hall.vug", "include \"door.vug\"");
  add("looks/door.vug", "include \"hall.vug\"");
  const std::string cycle = fault("include \"hall.vug\"");
  EXPECT_EQ(cycle.rfind("files include each other in a cycle / ", 0), 0u) << cycle;
}

}  // namespace
}  // namespace vug::scene
