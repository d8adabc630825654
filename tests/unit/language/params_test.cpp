// SPDX-License-Identifier: Apache-2.0
// Parameters as sliders: their values, and texts of other values in the unit of the text.
#include "texts.h"

#include <vug/language/edits.h>
#include <vug/language/params.h>

namespace vug::language {
namespace {

const char* const kText =
    "param SIZE = 30cm  in 1cm..3m  \"edge of a block\"  # note\n"
    "param COUNT = 4 in 1..32\n"
    "param SHARE = 52%  in 0%..100%\n"
    "param TURN = -12.5deg in -90deg..90deg\n"
    "param WIDE = 2 * SIZE in 0m..10m\n"
    "param GAIN = 1.5 in 0..2\n"
    "param AXIS = +X\n"
    "param FREE = 3m\n";

ParamSetting param(const Analysis& analysis, const std::string& name) {
  for (const ParamSetting& each : params_of(analysis))
    if (each.name == name) return each;
  ADD_FAILURE() << name;
  return {};
}

TEST(Params, HaveTheirTextsAndRanges) {
  const MarkedText text(kText);
  ASSERT_EQ(params_of(*text.analysis).size(), 8u);
  const ParamSetting size = param(*text.analysis, "SIZE");
  EXPECT_EQ(size.text, "30cm");
  EXPECT_EQ(size.range, "1cm..3m");
  EXPECT_EQ(size.doc, "edge of a block");
  EXPECT_EQ(size.where.line, 1);
  ASSERT_TRUE(size.has_slider());
  EXPECT_NEAR(size.fraction(), 0.29 / 2.99, 1e-12);
  EXPECT_FALSE(size.whole);
  EXPECT_TRUE(param(*text.analysis, "COUNT").whole);
  EXPECT_EQ(param(*text.analysis, "WIDE").text, "2 * SIZE");
  EXPECT_FALSE(param(*text.analysis, "AXIS").has_slider());
  EXPECT_FALSE(param(*text.analysis, "FREE").has_slider());
}

TEST(Params, SlidersWriteTheUnitOfTheText) {
  const MarkedText text(kText);
  const auto at = [&](const char* name, double fraction) {
    return slider_text(param(*text.analysis, name), fraction);
  };
  EXPECT_EQ(at("SIZE", 0), "1cm");
  EXPECT_EQ(at("SIZE", 1), "300cm");
  EXPECT_EQ(at("SIZE", 0.25), "76cm");
  EXPECT_EQ(at("COUNT", 0.5), "17");
  EXPECT_EQ(at("SHARE", 0.25), "25%");
  EXPECT_EQ(at("TURN", 0.5), "0deg");
  EXPECT_EQ(at("TURN", 0.25), "-45deg");
  EXPECT_EQ(at("GAIN", 0.5), "1");
  EXPECT_EQ(at("GAIN", 0.333), "0.67");
  EXPECT_EQ(at("WIDE", 0.5), "5m");
  EXPECT_EQ(at("WIDE", 7), "10m");
}

TEST(Params, ASliderTextParsesToItsPosition) {
  const MarkedText text(kText);
  for (const char* name : {"SIZE", "SHARE", "TURN", "GAIN"})
    for (int step = 0; step <= 20; ++step) {
      const double fraction = step / 20.0;
      const std::string written = slider_text(param(*text.analysis, name), fraction);
      Workspace workspace;
      workspace.open("x.vug", apply(kText, {set_param(*text.analysis, name, written)}));
      const ParamSetting now = param(*workspace.analyse("x.vug"), name);
      EXPECT_EQ(now.text, written);
      EXPECT_NEAR(now.fraction(), fraction, 0.006) << name << " = " << written;
    }
}

TEST(Params, ATextWithErrorsHasTheOtherParams) {
  const MarkedText text("param A = sphere( in 1..2\nparam B = 3 in 1..4\n");
  EXPECT_TRUE(param(*text.analysis, "B").has_slider());
}

}  // namespace
}  // namespace vug::language
