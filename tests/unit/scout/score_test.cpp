// SPDX-License-Identifier: Apache-2.0
// Each term of the score on views for which it has a closed form.
#include "synthetic.h"

#include <gtest/gtest.h>
#include <vug/scout/score.h>

#include <algorithm>
#include <cmath>

namespace vug::scout {
namespace {

View flat() {
  return view_of([](double, double) { return surface(5); });
}

TEST(Score, DepthIsTheLogarithmicRangeOverThreeOctaves) {
  const auto ranged = [](double factor) {
    return view_of([&](double u, double) { return surface(u < 0.5 ? 2 : 2 * factor); });
  };
  EXPECT_NEAR(score(ranged(8)).depth, 1, 1e-6);
  EXPECT_NEAR(score(ranged(2)).depth, 1.0 / 3, 1e-6);
  EXPECT_NEAR(score(ranged(64)).depth, 1, 1e-6);
  EXPECT_EQ(score(flat()).depth, 0);
}

TEST(Score, ThreeEqualLayersAreTheBest) {
  const View three = view_of([](double, double v) {
    return surface(v < 1.0 / 3 ? 16 : v < 2.0 / 3 ? 4 : 1);
  });
  EXPECT_NEAR(score(three).layers, 1, 1e-6);
  EXPECT_EQ(score(flat()).layers, 0);
  const View ramp = view_of([](double u, double) { return surface(std::exp(3 * u)); });
  EXPECT_NEAR(score(ramp).layers, 8.0 / 9, 0.01)
      << "thirds of a uniform distribution leave a ninth of its variance";
}

TEST(Score, OtsuFindsTheGapsBetweenThreeClasses) {
  std::vector<double> values;
  for (int i = 0; i < 20; ++i) values.push_back(0 + 0.001 * i);
  for (int i = 0; i < 30; ++i) values.push_back(5 + 0.001 * i);
  for (int i = 0; i < 50; ++i) values.push_back(9 + 0.001 * i);
  const OtsuClasses classes = otsu_classes(values);
  EXPECT_GT(classes.low, 0.019);
  EXPECT_LT(classes.low, 5);
  EXPECT_GT(classes.high, 5.029);
  EXPECT_LT(classes.high, 9);
  EXPECT_EQ(classes.shares, (std::array{0.2, 0.3, 0.5}));
  EXPECT_GT(classes.separation, 0.999);
}

/// A deep spot of 7 % of the picture around (u0, v0).
View spot(double u0, double v0) {
  return view_of([&](double u, double v) {
    const double du = (u - u0) / 0.13, dv = (v - v0) / 0.13;
    return surface(std::fabs(du) < 1 && std::fabs(dv) < 1 ? 30 : 3);
  });
}

TEST(Score, TheDeepestPartLeadsAtThirdsAndTheCentre) {
  EXPECT_NEAR(score(spot(1.0 / 3, 2.0 / 3)).lead, 1, 0.02);
  EXPECT_NEAR(score(spot(0.5, 0.5)).lead, 0.7, 0.02);
  EXPECT_LT(score(spot(0.88, 0.88)).lead, 0.1);
}

TEST(Score, SpokesTowardsTheDeepestPartAreLinesAndRingsAreNot) {
  const auto with = [](const auto& l) {
    return view_of([&](double u, double v) {
      const double x = u - 0.5, y = v - 0.5, r = std::hypot(x, y);
      return surface(r < 0.12 ? 50 : std::exp(l(r, std::atan2(y, x))));
    });
  };
  EXPECT_GT(score(with([](double, double angle) { return 1 + std::sin(8 * angle); })).lines, 0.9);
  EXPECT_EQ(score(with([](double r, double) { return 2 - 2 * r; })).lines, 0);
}

TEST(Score, NearSurfacesFrameThePicture) {
  const auto framed = [](double border, double middle) {
    int i = 0;
    return view_of([&](double u, double v) {
      const bool outer = std::min({u, 1 - u, v, 1 - v}) < 0.15;
      // The far pixels form two classes, so that the near ones are a class of their own.
      const double share = outer ? border : middle, random = std::fmod(0.618033988749895 * ++i, 1);
      return surface(random < share ? 1 : i % 2 ? 20 : 60);
    });
  };
  EXPECT_GT(score(framed(0.45, 0.1)).frame, 0.9);
  EXPECT_LT(score(framed(0.1, 0.1)).frame, 0.1);
  EXPECT_LT(score(framed(0.95, 0.05)).frame, 0.1);
}

TEST(Score, EdgesAreBalancedAroundTheMiddle) {
  const auto step = [](double at) {
    return view_of([&](double u, double) { return surface(u < at ? 2 : 8); });
  };
  EXPECT_NEAR(score(step(0.5)).balance, 1, 0.02);
  EXPECT_NEAR(score(step(0.375)).balance, 0.5, 0.03);
  EXPECT_EQ(score(step(0.2)).balance, 0);
  EXPECT_EQ(score(flat()).balance, 0) << "no edges";
}

TEST(Score, PartsOfEqualSizeHaveNoContrastOfSizes) {
  const View equal = view_of([](double u, double) { return surface(u < 0.5 ? 2 : 8); });
  EXPECT_NEAR(score(equal).sizes, 0, 1e-9);
  // One large part and four single pixels: sd of (ln a, 4 times ln b) = 0.4 ln(a / b).
  View mixed = flat();
  for (const int x : {5, 15, 25, 35}) mixed.at(x, 10).distance = 1;
  EXPECT_NEAR(score(mixed).sizes, std::min(1.0, 0.4 * std::log(2300.0) / 1.2), 1e-9);
  mixed.at(5, 10).distance = mixed.at(15, 10).distance = 5;  // fewer than three small parts
  EXPECT_NEAR(score(mixed).sizes, 0.5 * std::min(1.0, std::sqrt(2.0) / 3 * std::log(2302.0) / 1.2),
              1e-9);
}

TEST(Score, NormalsInAllDirectionsAreTooManyAndOneIsTooFew) {
  EXPECT_EQ(score(flat()).directions, 0);
  // The corners of a dodecahedron are the middles of the 20 faces.
  const float golden = 1.618034f;
  std::vector<Vec3f> corners;
  for (const float a : {-1.0f, 1.0f})
    for (const float b : {-1.0f, 1.0f}) {
      for (const float c : {-1.0f, 1.0f}) corners.emplace_back(a, b, c);
      corners.emplace_back(0.0f, a / golden, b * golden);
      corners.emplace_back(a / golden, b * golden, 0.0f);
      corners.emplace_back(a * golden, 0.0f, b / golden);
    }
  size_t i = 0;
  const View all =
      view_of([&](double, double) { return surface(5, corners[i++ % 20] / std::sqrt(3.0f)); });
  EXPECT_NEAR(score(all).directions, 0.5, 1e-3);
  // Ten faces: ln 10 / ln 20 = 0.769.
  const View half = view_of(
      [&](double, double) { return surface(5, corners[2 * (i++ % 10)] / std::sqrt(3.0f)); });
  EXPECT_NEAR(score(half).directions, 1 - (std::log(10.0) / std::log(20.0) - 0.75) / 0.5, 1e-3);
}

TEST(Score, ClutterCostsThePicture) {
  EXPECT_EQ(score(flat()).clear, 1);
  const View noise = view_of([i = 0](double, double) mutable { return surface(++i % 3 ? 2 : 8); });
  EXPECT_EQ(score(noise).clear, 0);
  const View step = view_of([](double u, double) { return surface(u < 0.5 ? 2 : 8); });
  EXPECT_EQ(score(step).clear, 1) << "two columns of 64";
}

TEST(Score, LandmarksCountByWeightAreaAndWholeness) {
  const auto with_object = [](double u0, double share) {
    return view_of([&](double u, double v) {
      const double side = std::sqrt(share);
      const bool inside = u >= u0 && u < u0 + side && v > 0.4 && v < 0.4 + side;
      return surface(5, {1, 0, 0}, inside ? 7 : 0);
    });
  };
  Landmarks landmarks;
  landmarks.weights[7] = 0.9;
  EXPECT_NEAR(score(with_object(0.4, 0.05), landmarks).landmarks, 0.3, 1e-9);
  EXPECT_NEAR(score(with_object(0, 0.05), landmarks).landmarks, 0.18, 1e-9) << "cut by the edge";
  EXPECT_LT(score(with_object(0.4, 0.01), landmarks).landmarks, 0.2) << "half of 2 %";
  EXPECT_EQ(score(with_object(0.4, 0.05)).landmarks, 0);
}

TEST(Score, AFigureShowsTheScaleIfItIsNeitherTinyNorLarge) {
  const auto with_figure = [](double height) {
    return view_of([&](double u, double v) {
      return surface(5, {1, 0, 0},
                     std::fabs(u - 0.5) < 0.02 && std::fabs(v - 0.5) < height / 2 ? 7 : 0);
    });
  };
  Landmarks landmarks;
  landmarks.known_size[7] = true;
  EXPECT_EQ(score(with_figure(0.2), landmarks).size_known, 1);
  EXPECT_EQ(score(with_figure(0.5), landmarks).size_known, 0.5);
  EXPECT_EQ(score(flat(), landmarks).size_known, 0.5);
  const View cut = view_of([](double u, double v) {
    return surface(5, {1, 0, 0}, std::fabs(u - 0.5) < 0.02 && v > 0.8 ? 7 : 0);
  });
  EXPECT_EQ(score(cut, landmarks).size_known, 0.1) << "a figure without feet";
}

TEST(Score, EveryFactorIsNecessaryAndSummandsAddUp) {
  ScoreTerms terms{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  EXPECT_NEAR(terms.total(), 1, 1e-9);
  terms.lines = 0;
  EXPECT_NEAR(terms.total(), 0.75, 1e-9);
  terms.lead = 0.125;
  EXPECT_NEAR(terms.total(), 0.375, 1e-9);
  terms.clear = 0;
  EXPECT_EQ(terms.total(), 0);
}

}  // namespace
}  // namespace vug::scout
