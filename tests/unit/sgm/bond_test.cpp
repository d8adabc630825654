// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/bond.h>

#include <gtest/gtest.h>

#include <array>

namespace vug::sgm {
namespace {

TEST(Label, NamesAreParsedBack) {
  for (const std::string& name : label_names()) EXPECT_EQ(to_string(*label_from(name)), name);
  EXPECT_EQ(label_from("+x"), Label::plus_x);
  EXPECT_EQ(label_from("RANDOM"), Label::random);
  EXPECT_FALSE(label_from("+W"));
  EXPECT_FALSE(label_from(""));
}

TEST(Label, SidesHaveOpposites) {
  for (int s = 0; s < 6; ++s) {
    const Label side = static_cast<Label>(s);
    EXPECT_EQ(direction(opposite(side)), -direction(side));
    EXPECT_TRUE(on_side({Vec3d(0), direction(side)}, side));
    EXPECT_FALSE(on_side({Vec3d(0), direction(side)}, opposite(side)));
  }
  EXPECT_EQ(direction(Label::plus_x), Vec3d(1, 0, 0));
  EXPECT_EQ(direction(Label::minus_z), Vec3d(0, 0, -1));
}

TEST(Label, RandomIsUniformOverTheSides) {
  std::array<double, 6> seen{};
  for (uint64_t i = 0; i < 60000; ++i)
    ++seen[static_cast<size_t>(sample_side(Label::random, RandomKey(5).at(i)))];
  double chi2 = 0;
  for (const double n : seen) chi2 += (n - 10000) * (n - 10000) / 10000;
  EXPECT_LT(chi2, 20.5);  // 5 degrees of freedom, p = 0.001
  EXPECT_EQ(sample_side(Label::minus_y, RandomKey(1)), Label::minus_y);
}

// Definition 5 with its tolerance scaled by the shape.
TEST(MakesLabel, RequiresCoincidingPointsAndOppositeDirections) {
  const Bond a{{1, 2, 3}, {1, 0, 0}}, b{{1, 2, 3}, {-1, 0, 0}};
  EXPECT_TRUE(makes_label(a, b, 1));
  EXPECT_FALSE(makes_label(a, a, 1));
  EXPECT_FALSE(makes_label(a, {{1, 2, 3.001}, {-1, 0, 0}}, 1));
  EXPECT_TRUE(makes_label(a, {{1, 2, 3.001}, {-1, 0, 0}}, 10000));
  EXPECT_FALSE(makes_label(a, {{1, 2, 3}, {0, -1, 0}}, 1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(makes_label(a, {{1, 2, nan}, {-1, 0, 0}}, 1));
}

TEST(MakesLabel, NoDirectionJoinsAnything) {
  const Bond any{{1, 2, 3}, {0, 0, 0}};
  for (int s = 0; s < 6; ++s) {
    EXPECT_TRUE(makes_label(any, {{1, 2, 3}, direction(static_cast<Label>(s))}, 1));
    EXPECT_TRUE(on_side(any, static_cast<Label>(s)));
  }
  EXPECT_TRUE(makes_label(any, any, 1));
}

}  // namespace
}  // namespace vug::sgm
