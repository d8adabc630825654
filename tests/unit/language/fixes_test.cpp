// SPDX-License-Identifier: Apache-2.0
// Corrections of faults and changes on request.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/language/check.h>
#include <vug/language/fixes.h>

namespace vug::language {
namespace {

/// The text after the first correction of the first diagnostic that has one.
std::string corrected(const std::string& source) {
  const MarkedText text(source);
  const CheckResult result = check_scene(text.workspace, text.analysis->file);
  for (const Diagnostic& each : result.diagnostics.all())
    for (const Fix& fix : fixes_for(*text.analysis, each)) return apply(text.text, fix.edits);
  return "none";
}

constexpr const char* kRest = "mesh m on v {}\n";

TEST(Fixes, ANearNameReplacesTheUnknownOne) {
  EXPECT_EQ(corrected("let radius = 1m\nvolume v = level_set(sphere(radios), voxel: 5cm)\n"),
            "let radius = 1m\nvolume v = level_set(sphere(radius), voxel: 5cm)\n");
  EXPECT_EQ(corrected("volume v = level_set(sphere(raduis: 1m), voxel: 5cm)\n"),
            "volume v = level_set(sphere(radius: 1m), voxel: 5cm)\n");
  EXPECT_EQ(corrected("volume v = level_set(sphree(1m), voxel: 5cm)\n"),
            "volume v = level_set(sphere(1m), voxel: 5cm)\n");
  EXPECT_EQ(corrected("volume v = level_set(sphere(1m), voxel: 5cn)\n"),
            "volume v = level_set(sphere(1m), voxel: 5cm)\n");
}

TEST(Fixes, AFunctionOfTheKitIsIncluded) {
  const std::string text = corrected(
      std::string(
          "# A pool.\nlet rim = pool_rim()\nvolume v = level_set(sphere(1m), voxel: 5cm)\n") +
      kRest);
  EXPECT_EQ(text.substr(0, 62),
            "# A pool.\ninclude \"kit/stains.vug\" as stains\nlet rim = stains.");
}

TEST(Fixes, ACodeOfAColourBecomesACall) {
  EXPECT_EQ(corrected("mesh m on v { paint #c0a080 }\n"),
            "mesh m on v { paint srgb(\"#c0a080\") }\n");
}

TEST(Fixes, ANumberBecomesAParamOfTheSameValue) {
  const MarkedText text("# Ball.\nvolume v = level_set(sphere(radius: 1|m), voxel: 5cm)\n");
  const auto fixes = refactorings_at(*text.analysis, text.position);
  ASSERT_EQ(fixes.size(), 1u);
  EXPECT_EQ(
      apply(text.text, fixes[0].edits),
      "# Ball.\nparam radius = 1m\nvolume v = level_set(sphere(radius: radius), voxel: 5cm)\n");
}

}  // namespace
}  // namespace vug::language
