// SPDX-License-Identifier: Apache-2.0
// Swatches of linear colours.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/base/srgb.h>
#include <vug/language/colours.h>

namespace vug::language {
namespace {

TEST(Colours, SwatchesAreEncodedAndTheirTextsDecoded) {
  const MarkedText text("material m = lambert(albedo: (0.5, 0.2, 0))\nlet p = (0.5, 0.2, 0)\n");
  const auto swatches = swatches_of(*text.analysis);
  ASSERT_EQ(swatches.size(), 1u);  // a vector without a colour's name is not one
  EXPECT_EQ(text_of(text.workspace, swatches[0].range), "(0.5, 0.2, 0)");
  EXPECT_NEAR(swatches[0].srgb.x, srgb_encode(0.5), 1e-12);
  EXPECT_EQ(colour_texts(swatches[0], swatches[0].srgb, false)[0], "(0.5, 0.2, 0)");
  EXPECT_EQ(colour_texts(swatches[0], Vec3d(1, 0, 0), false)[1], "srgb(\"#ff0000\")");
}

TEST(Colours, BrightOnesKeepTheirScale) {
  const MarkedText text("light l = rect(radiance: (60, 30, 9))\n");
  const auto swatches = swatches_of(*text.analysis);
  ASSERT_EQ(swatches.size(), 1u);
  EXPECT_DOUBLE_EQ(swatches[0].scale, 60);
  EXPECT_EQ(colour_texts(swatches[0], swatches[0].srgb, false),
            std::vector<std::string>{"(60, 30, 9)"});
}

TEST(Colours, CodesRoundTrip) {
  const MarkedText text("let a = srgb(\"#c0a080\")\n");
  const auto swatches = swatches_of(*text.analysis);
  ASSERT_EQ(swatches.size(), 1u);
  EXPECT_TRUE(is_code(*text.analysis, swatches[0].range));
  EXPECT_EQ(colour_texts(swatches[0], swatches[0].srgb, true)[0], "srgb(\"#c0a080\")");
}

}  // namespace
}  // namespace vug::language
