// SPDX-License-Identifier: Apache-2.0
// Checks of texts that are not saved.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/language/check.h>

namespace vug::language {
namespace {

TEST(Check, ReadsOpenTextsInPlaceOfFiles) {
  Workspace workspace(with_data());
  workspace.open("/scenes/part.vug", "let ball = sphere(1m)\n");
  workspace.open("/scenes/main.vug",
                 "include \"part.vug\"\nvolume v = level_set(ball, voxel: 5cm)\n");
  EXPECT_TRUE(check_scene(workspace, "/scenes/main.vug").diagnostics.all().empty());
  workspace.open("/scenes/part.vug", "let ball = sphere(1s)\n");
  const CheckResult result = check_scene(workspace, "/scenes/main.vug");
  ASSERT_EQ(result.diagnostics.all().size(), 1u);
  EXPECT_EQ(result.diagnostics.all()[0].where.file, "/scenes/part.vug");
  EXPECT_EQ(result.sources.size(), 2u);
}

TEST(Check, ReportsLightsInRock) {
  const MarkedText text(
      "volume v = level_set(box(size: (9, 9, 9)), voxel: 20cm)\nmesh m on v {}\nobject o on m {}\n"
      "camera c { eye (0, 0, 20)  target (0, 0, 0) }\nlight l = sphere(radius: 5cm)\nrender r "
      "{}\n");
  const auto result = check_scene(text.workspace, text.analysis->file);
  ASSERT_FALSE(result.diagnostics.all().empty());
  EXPECT_EQ(result.diagnostics.all()[0].where.line, 5);
}

TEST(Check, WarnsAboutDripsThatAreAddedButDoNotDrip) {
  const std::string scene =
      "let room = complement(box(size: (6, 3, 6)))\n"
      "drips water = seepage(room, from: (-2, -1, -2), to: (2, 2, 2),\n"
      "  edits: [EDIT])\n"
      "volume v = level_set(speleothems(of: water), voxel: 20cm, from: (-4, -2, -4), to: (4, 2, "
      "4))\n";
  const auto first = [&](const std::string& edit) {
    std::string text = scene;
    const MarkedText marked(text.replace(text.find("EDIT"), 4, edit));
    const CheckResult result =
        check_scene(marked.workspace, marked.analysis->file, {.thorough = true});
    EXPECT_EQ(result.diagnostics.all().size(), 1u);
    return result.diagnostics.all().empty() ? Diagnostic() : result.diagnostics.all()[0];
  };
  const Diagnostic lost = first("add_drip(at: (0, 0, 0))");
  EXPECT_EQ(lost.severity, Severity::warning);
  EXPECT_EQ(lost.where.line, 3);
  EXPECT_EQ(lost.where.column, 11);
  EXPECT_NE(lost.message.find("the added drip -1 does not drip"), std::string::npos)
      << lost.message;
  const Diagnostic unknown = first("remove_drip(drip: 99999)");
  EXPECT_EQ(unknown.severity, Severity::error);
  EXPECT_EQ(unknown.where.line, 3);
}

TEST(Check, AMissingFileIsADiagnostic) {
  const Workspace workspace(with_data());
  EXPECT_TRUE(check_scene(workspace, "/scenes/none.vug").diagnostics.has_errors());
}

}  // namespace
}  // namespace vug::language
