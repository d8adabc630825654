// SPDX-License-Identifier: Apache-2.0
// IES files: their contents, and the messages for invalid ones.
#include <vug/base/error.h>
#include <vug/render/lighting/ies_profile.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vug::render {
namespace {

constexpr const char* kHead = "IESNA:LM-63-1995\r\n[TEST] none\r\nTILT=NONE\r\n";

IesProfile profile(const std::string& numbers) { return {kHead + numbers, "test.ies"}; }

std::string refusal_of_profile(const std::string& text) {
  try {
    const IesProfile made(text, "test.ies");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    return error.what();
  }
  return "accepted";
}

TEST(Ies, IntegratesToItsRatedLumen) {
  const IesProfile cosine = read_ies(VUG_TEST_DATA "/lights/cosine.ies");
  // Intensities are linear between angles of 2.5 degrees: below the cosine by up to 2.4e-4.
  EXPECT_NEAR(cosine.lumen(), cosine.rated_lumen(), 5e-4 * cosine.rated_lumen());
  EXPECT_NEAR(cosine.rated_lumen(), 1000 * M_PI, 0.1);
  EXPECT_EQ(cosine.peak(), 1000);
  EXPECT_NEAR(cosine.candela(std::cos(1.0f), 0.3f), 1000 * std::cos(1.0), 0.3);
  EXPECT_EQ(cosine.candela(-0.1f, 0), 0);
  EXPECT_NEAR(cosine.lowest_cosine(), 0, 0.003);
}

TEST(Ies, SymmetriesAreExpanded) {
  const std::string tail = "1 -1 2.0 2 ";
  const IesProfile quadrant = profile(tail + "2 1 1 0 0 0 1 1 9\n0 180\n0 90\n1 1 3 3");
  for (const float turn : {0.125f, 0.375f, 0.625f, 0.875f})
    EXPECT_NEAR(quadrant.candela(0, turn), 4, 1e-4) << "midway, and doubled";
  EXPECT_NEAR(quadrant.candela(0, 0.25f), 6, 1e-4);
  EXPECT_NEAR(quadrant.candela(0, 0.5f), 2, 1e-4);
  EXPECT_EQ(quadrant.rated_lumen(), -1);
  EXPECT_NEAR(quadrant.lumen(), 4 * M_PI * 4, 0.01);
  const IesProfile half = profile(tail + "2 1 1 0 0 0 1 1 9\n0 180\n0 180\n1 1 3 3");
  EXPECT_NEAR(half.candela(0, 0.25f), 4, 1e-4);
  EXPECT_NEAR(half.candela(0, 0.75f), 4, 1e-4);
  EXPECT_NEAR(half.candela(0, 0.5f), 6, 1e-4);
  const IesProfile round = profile(tail + "1 1 1 0 0 0 0.5 1 9\n0 180\n0\n1 3");
  EXPECT_NEAR(round.candela(0, 0.77f), 2, 1e-4) << "the ballast factor halves";
  const IesProfile tilted(
      "IESNA91\nTILT=INCLUDE\n1\n2\n0 90\n1 1\n1 -1 1 2 1 1 1 0 0 0 1 1 9\n0 90\n0\n5 5", "t");
  EXPECT_EQ(tilted.peak(), 5);
}

TEST(Ies, InvalidFilesAreReportedByLine) {
  const std::string head = kHead;
  EXPECT_NE(refusal_of_profile("").find("line 1"), std::string::npos);
  EXPECT_NE(refusal_of_profile("P6 3 3").find("IESNA"), std::string::npos);
  EXPECT_NE(refusal_of_profile("IESNA91\n[A] b\n").find("TILT="), std::string::npos);
  EXPECT_NE(refusal_of_profile("IESNA91\nTILT=lamp.tlt\n1 1").find("line 2"), std::string::npos);
  EXPECT_NE(refusal_of_profile(head + "1 -1 1 2 1 1 1 0 0 0\n1 1 9\n0 x").find("line 6: 'x'"),
            std::string::npos);
  EXPECT_NE(refusal_of_profile(head + "1 -1 1 2 1 3 1").find("type C"), std::string::npos);
  EXPECT_NE(refusal_of_profile(head + "1 -1 1 2.5 1 1 1").find("whole number"), std::string::npos);
  EXPECT_NE(refusal_of_profile(head + "1 -1 1 9999 9999 1 1").find("four million"),
            std::string::npos);
  const std::string tail = head + "1 -1 1 2 2 1 1 0 0 0 1 1 9\n";
  EXPECT_NE(refusal_of_profile(tail + "90 0\n").find("must ascend"), std::string::npos);
  EXPECT_NE(refusal_of_profile(tail + "0 90\n0 70\n").find("must end with 90"), std::string::npos);
  EXPECT_NE(refusal_of_profile(tail + "0 90\n0 90\n1 2 -3 4").find("below 0"), std::string::npos);
  EXPECT_NE(refusal_of_profile(tail + "0 90\n0 90\n1 2 3").find("ends before"), std::string::npos);
  EXPECT_NE(refusal_of_profile(tail + "0 90\n0 90\n0 0 0 0").find("all intensities"),
            std::string::npos);
  EXPECT_NE(refusal_of_profile(tail + "0 90\n0 90\n1 nan 1 1").find("is not a number"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::render
