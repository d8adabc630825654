// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/plot.h>

#include <gtest/gtest.h>
#include <vug/base/error.h>

#include <cmath>

namespace vug::flora {
namespace {

std::string plot_fault(const Corners& corners) {
  try {
    const Plot plot(corners);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    return error.what();
  }
}

/// An L: a square of side 2 without the quarter of large x and y.
const Corners kBent = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

TEST(Plot, HasItsAreaAndContainsItsPoints) {
  const Plot plot(kBent);
  EXPECT_NEAR(plot.area(), 3, 1e-15);
  EXPECT_EQ(plot.low(), Vec2d(0, 0));
  EXPECT_EQ(plot.high(), Vec2d(2, 2));
  EXPECT_TRUE(plot.contains({0.5, 1.9}));
  EXPECT_TRUE(plot.contains({1.9, 0.5}));
  EXPECT_FALSE(plot.contains({1.5, 1.5}));
  EXPECT_FALSE(plot.contains({-0.1, 1}));
  EXPECT_NEAR(plot.border_distance({1.5, 1.5}), 0.5, 1e-15);
  EXPECT_NEAR(plot.border_distance({0.25, 0.5}), 0.25, 1e-15);
  EXPECT_EQ(plot.first_reflex_corner(), 3);
  const Corners turned(kBent.rbegin(), kBent.rend());
  EXPECT_NEAR(Plot(turned).area(), 3, 1e-15);
  EXPECT_EQ(Plot(turned).first_reflex_corner(), 2);
  EXPECT_EQ(Plot({{0, 0}, {1, 0}, {2, 0}, {1, 1}}).first_reflex_corner(),
            -1);  // Collinear corners are not concave.
}

TEST(Plot, SamplesUniformly) {
  const Plot plot(kBent);
  constexpr int kCount = 300000;
  std::array<int, 3> in{};
  for (int i = 0; i < kCount; ++i) {
    RandomStream random(RandomKey(9).at(static_cast<uint64_t>(i)));
    const Vec2d p = plot.point(random);
    ASSERT_TRUE(plot.contains(p) || plot.border_distance(p) < 1e-12);
    ++in[p.y > 1 ? 0 : p.x > 1 ? 1 : 2];
  }
  for (const int count : in) EXPECT_NEAR(count, kCount / 3.0, 5 * std::sqrt(kCount * 2.0 / 9));
}

TEST(Plot, RejectsNonSimplePolygonsWithTheLocation) {
  EXPECT_EQ(plot_fault({{0, 0}, {1, 0}}), "a polygon needs at least 3 corners, not 2");
  EXPECT_EQ(plot_fault({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
            "sides 1 and 3 of the polygon cross or touch at (1, 1)");
  EXPECT_EQ(plot_fault({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
            "corners 2 and 3 of the polygon are both at (1, 0)");
  EXPECT_EQ(plot_fault({{0, 0}, {2, 0}, {1, 0}, {1, 1}}),
            "side 2 of the polygon runs back along side 1, from (2, 0)");
  // A corner on another side: the plot would fall apart there.
  EXPECT_EQ(plot_fault({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}),
            "sides 1 and 4 of the polygon cross or touch at (2, 0)");
  EXPECT_NE(plot_fault({{0, 0}, {1, NAN}, {0, 1}}).find("corner 2"), std::string::npos);
  EXPECT_NE(plot_fault({{0, 0}, {1e7, 0}, {0, 1}}).find("at most 1e6 m"), std::string::npos);
  EXPECT_NE(plot_fault({{0, 0}, {1, 1}, {2, 2}}), "");
  EXPECT_EQ(plot_fault(kBent), "");
}

TEST(Plot, TouchingIsExact) {
  // The concave corner on the long side, and next to it by the last digit in both directions.
  const auto dented = [](double y) {
    return Corners{{0, 0}, {1000, 0}, {1000, 1}, {300, y}, {0, 1}};
  };
  EXPECT_EQ(plot_fault(dented(0)), "sides 1 and 4 of the polygon cross or touch at (300, 0)");
  EXPECT_EQ(plot_fault(dented(5e-324)), "");
  EXPECT_NE(plot_fault(dented(-5e-324)), "");
  // Overlapping sides, which have no single intersection.
  EXPECT_EQ(plot_fault({{0, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 0}, {1, 0}, {1, 2}, {0, 2}}),
            "sides 1 and 5 of the polygon cross or touch at (3, 0)");
}

TEST(Plot, AcceptsThinSmallAndLargePolygons) {
  const auto turned = [](const Corners& corners, double angle) {
    Corners out;
    for (const Vec2d& p : corners)
      out.emplace_back(p.x * std::cos(angle) - p.y * std::sin(angle),
                       p.x * std::sin(angle) + p.y * std::cos(angle));
    return out;
  };
  // A millimetre wide, 10 km long, a bend of a millimetre in 10 km, collinear corners.
  for (const double angle : {0.0, 0.3, 1.0})
    for (const double across : {1e-3, 1.0}) {
      const Corners thin = {{0, 0},        {2500, 0},      {5000, 0},
                            {1e4, across}, {5000, across}, {0, across}};
      const Plot plot(turned(thin, angle));
      EXPECT_NEAR(plot.area() / (7500 * across), 1, 1e-6) << angle;
      RandomStream random(RandomKey(3));
      for (int i = 0; i < 200; ++i) EXPECT_LT(plot.border_distance(plot.point(random)), across);
    }
  // Corners that were collinear before a rotation do not count as concave; slightly concave ones
  // do.
  const auto bent = [](double by) {
    return Corners{{0, 0}, {1, by}, {2, by}, {3, 0}, {3, 1}, {1.5, 1}, {0, 1}};
  };
  for (int i = 0; i < 50; ++i)
    for (const double size : {1e-3, 1.0, 1e4}) {
      Corners corners = turned(bent(0), 0.1 * i);
      for (Vec2d& p : corners) p *= size;
      EXPECT_EQ(Plot(corners).first_reflex_corner(), -1) << i;
    }
  EXPECT_EQ(Plot(bent(1e-7)).first_reflex_corner(), 1);
  EXPECT_NEAR(Plot(turned({{0, 0}, {1e-3, 0}, {1e-3, 1e-3}, {0, 1e-3}}, 0.3)).area(), 1e-6, 1e-18);
  EXPECT_NEAR(Plot(turned({{0, 0}, {1e4, 0}, {1e4, 1e4}, {0, 1e4}}, 0.3)).area(), 1e8, 1e-4);
}

TEST(Plot, AcceptsSmallPolygonsFarAway) {
  const Vec2d far(123456.5, -654321.25);
  const Plot plot({far, far + Vec2d(0.01, 0), far + Vec2d(0.01, 0.02), far + Vec2d(0, 0.02)});
  EXPECT_NEAR(plot.area(), 2e-4, 1e-10);
}

}  // namespace
}  // namespace vug::flora
