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

TEST(Check, AMissingFileIsADiagnostic) {
  const Workspace workspace(with_data());
  EXPECT_TRUE(check_scene(workspace, "/scenes/none.vug").diagnostics.has_errors());
}

}  // namespace
}  // namespace vug::language
