// SPDX-License-Identifier: Apache-2.0
// The forms of dripstone: published and derived numbers, and the turned solids made of them.
#include <vug/base/rng.h>
#include <vug/field/lathe.h>
#include <vug/field/registry.h>
#include <vug/field/speleothems/stalactite_curve.h>
#include <vug/field/speleothems/stalagmite_curve.h>
#include <vug/field/speleothems/travertine_dome.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

TEST(StalactiteCurve, HasTheHeightsOfItsClosedForm) {
  const StalactiteCurve unit(1);
  EXPECT_NEAR(unit.least_radius(), 3.0792014, 1e-7);
  EXPECT_NEAR(unit.height_at(unit.least_radius()), 0, 1e-6);
  const struct {
    double radius, height;
  } points[] = {{4, 0.78403},         {12.5, 14.34088}, {100.0 / 3, 67.68541}, {135.2, 491.17459},
                {1020.1, 7596.73144}, {10, 9.5818},     {100, 323.7653},       {1000, 7396.4033}};
  for (const auto& p : points)
    EXPECT_NEAR(unit.height_at(p.radius) / p.height, 1, 1e-5) << p.radius;
  // (1 + s^2)^2 / s = r, with s the slope.
  for (const double r : {3.1, 5.0, 50.0}) {
    const double s = unit.slope_at(r), step = 1e-5;
    EXPECT_NEAR((1 + s * s) * (1 + s * s) / s, r, 1e-9 * r);
    EXPECT_NEAR((unit.height_at(r + step) - unit.height_at(r - step)) / (2 * step), s, 1e-5 * s);
  }
}

TEST(StalactiteCurve, FitsARootAndALength) {
  constexpr double kStraw = 0.00255;
  const struct {
    double root, length, scale;
    double radii[4];  // In mm at 10, 25, 50 and 75 % of the length from the tip.
  } forms[] = {
      {0.02, 0.5, 4.415e-7, {5.01, 8.07, 12.46, 16.38}},
      {0.05, 0.3, 8.751e-5, {10.16, 18.60, 30.28, 40.56}},
      {0.05, 1, 2.478e-6, {10.02, 18.44, 30.16, 40.49}},
      {0.15, 1, 2.011e-4, {28.02, 54.11, 89.88, 121.23}},
      {0.3, 3, 1.232e-4, {54.52, 107.01, 178.99, 242.08}},
      // Too short for the tip of a straw.
      {0.15, 0.4, 2.4336e-3, {32.92, 58.20, 92.58, 122.55}},
      {0.3, 0.6, 9.2891e-3, {76.00, 124.38, 190.19, 247.54}},
  };
  for (const auto& form : forms) {
    const StalactiteCurve curve = StalactiteCurve::fit(form.root, form.length, kStraw);
    EXPECT_NEAR(curve.scale() / form.scale, 1, 5e-4) << form.root << " " << form.length;
    const double tip = std::max(kStraw, curve.least_radius()), below = curve.height_at(tip);
    EXPECT_NEAR(curve.height_at(form.root) - below, form.length, 1e-9);
    const double parts[] = {0.1, 0.25, 0.5, 0.75};
    for (size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(curve.height_at(1e-3 * form.radii[i]) - below, parts[i] * form.length,
                  2e-3 * form.length);
  }
  EXPECT_NEAR(StalactiteCurve::fit(0.15, 0.4, kStraw).least_radius(), 0.00749, 1e-5);
}

TEST(StalagmiteCurve, HasTheDepthsOfTheCandle) {
  const StalagmiteCurve candle({1, 0, 1});
  const auto closed_form = [](double x) {
    const double u = std::sqrt(2 - x * x), root2 = std::sqrt(2.0);
    return root2 - u - 0.5 * std::log((u - 1) / (u + 1)) +
           0.5 * std::log((root2 - 1) / (root2 + 1));
  };
  for (const double x : {0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 0.999, 0.999999})
    EXPECT_NEAR(candle.depth_at(x), closed_form(x), 1e-8) << x;
  EXPECT_NEAR(candle.depth_at(0.5), 0.19661, 1e-5);
  EXPECT_NEAR(candle.depth_at(0.999), 3.33304, 1e-5);
}

TEST(TravertineDome, HasItsClosedFormAndDepths) {
  // Radii and depths of the unit dome at 15, 30, 45, 60 and 75 degrees, by a sum of 200,000 steps.
  const struct {
    double degrees, radius, depth;
  } points[] = {{15, 0.5358983849, 0.0497196281},
                {30, 0.8773826753, 0.1941972997},
                {45, 1.4142135624, 0.6217279480},
                {60, 2.6321480259, 2.3071788170},
                {75, 7.4641016151, 15.8280508418}};
  for (const auto& p : points) {
    const double angle = p.degrees * kPi / 180;
    EXPECT_NEAR(dome_radius(2, angle), 2 * p.radius, 1e-8 * p.radius);
    EXPECT_NEAR(dome_depth(2, angle), 2 * p.depth, 1e-6 * p.depth);
  }
}

TEST(StalagmiteCurve, HasTheDepthsOfFlatTopsAndCones) {
  const StalagmiteCurve flat({std::sqrt(1.25), 0.5, 1});
  EXPECT_NEAR(flat.depth_at(0.5), 0, 1e-9);
  EXPECT_NEAR(flat.depth_at(0.75), 0.14799, 1e-5);
  EXPECT_NEAR(flat.depth_at(0.9), 0.36965, 1e-5);
  EXPECT_NEAR(flat.depth_at(1.0), 0.6477891280, 1e-8);
  EXPECT_NEAR(flat.depth_at(1.1), 1.5012128274, 1e-8);
  const StalagmiteCurve cone({std::sqrt(0.7), 0, 0.7});
  EXPECT_NEAR(cone.depth_at(0.1), 0.10298, 1e-5);
  EXPECT_NEAR(cone.depth_at(0.25), 0.27040, 1e-5);
  EXPECT_NEAR(cone.depth_at(0.5), 0.65016, 1e-5);
  EXPECT_NEAR(cone.depth_at(0.7), 1.2374564318, 1e-8);
  EXPECT_NEAR(cone.depth_at(0.8), 2.0546048622, 1e-8);
}

TEST(StalagmiteCurve, PointsLieOnTheCurve) {
  for (const StalagmiteForm& form :
       {StalagmiteForm{0.1, 0, 1}, StalagmiteForm{0.1, 0.04, 1}, StalagmiteForm{0.1, 0.02, 0.8}}) {
    const StalagmiteCurve curve(form);
    const std::vector<Vec2d> points = curve.points(1.5, 30);
    EXPECT_NEAR(points.back().y, 1.5, 1e-9);
    EXPECT_LT(points.back().x, 0.1);
    for (const Vec2d& p : points) {
      if (p.y > 0.8) break;  // Farther down, the radius no longer determines the depth.
      EXPECT_NEAR(curve.depth_at(p.x), p.y, 1e-6);
    }
    for (size_t i = 1; i < points.size(); ++i) EXPECT_GT(points[i].x, points[i - 1].x);
  }
}

TEST(Lathe, OfATrapezoidIsACappedCone) {
  const Field turned = lathe("lathe", {{0, -1}, {2, -1}, {1, 1}, {0, 1}});
  const Field cone = make("capped_cone", {{"bottom", 2.0}, {"top", 1.0}, {"height", 2.0}});
  RandomStream random(RandomKey(3).at("lathe"));
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(-3, 3), y = random.uniform(-3, 3);
    const Vec3d p(x, y, random.uniform(-3, 3));
    EXPECT_NEAR(turned.value(p), cone.value(p), 1e-9) << p;
  }
  EXPECT_EQ(turned.bounds(), cone.bounds());
  EXPECT_EQ(turned.exactness(), Exactness::exact);
}

TEST(Lathe, IsHollowWhereTheOutlineKeepsOffTheAxis) {
  const Field tube = make("soda_straw", {{"length", 2.0}, {"radius", 0.5}, {"wall", 0.1}});
  EXPECT_NEAR(tube.value({0, -1, 0}), 0.4, 1e-12);
  EXPECT_NEAR(tube.value({0.45, -1, 0}), -0.05, 1e-12);
  EXPECT_NEAR(tube.value({0, -1, 0.8}), 0.3, 1e-12);
  EXPECT_NEAR(tube.value({0.45, -2.5, 0}), 0.5, 1e-12);
  const Field solid = make("soda_straw", {{"length", 2.0}, {"radius", 0.5}, {"wall", 0.9}});
  EXPECT_NEAR(solid.value({0, -1, 0}), -0.5, 1e-12);
}

TEST(Speleothem, EndsAndRootsAreWhereTheTextPutsThem) {
  const Field hanging = make("stalactite", {{"length", 1.0}, {"radius", 0.1}, {"root", 0.2}});
  EXPECT_NEAR(hanging.bounds().max.y, 0.2, 1e-12);
  EXPECT_LT(hanging.bounds().min.y, -1.0);
  EXPECT_GT(hanging.bounds().min.y, -1.003);  // The cap of a drop.
  EXPECT_NEAR(hanging.value({0.1, 0.1, 0}), 0, 1e-12);
  EXPECT_NEAR(hanging.value({0.1, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(hanging.value({0.00255, -1, 0}), 0, 1e-9);
  EXPECT_NEAR(hanging.value({0, 0.3, 0}), 0.1, 1e-12);
  const Field standing = make("stalagmite", {{"height", 1.0}, {"radius", 0.1}, {"root", 0.2}});
  EXPECT_NEAR(standing.value({0, 1, 0}), 0, 1e-9);
  EXPECT_NEAR(standing.bounds().min.y, -0.2, 1e-12);
  EXPECT_NEAR(standing.bounds().max.x, 0.1, 1e-3);
}

TEST(Speleothem, FaultsNameTheRemedy) {
  const auto fault_of = [](const std::string& kind, const NamedValues& params) -> std::string {
    try {
      make(kind, params);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(fault_of("stalactite", {{"radius", 0.01}, {"tip", 0.02}}).find("thinner than its root"),
            std::string::npos);
  EXPECT_NE(fault_of("stalagmite", {{"landing", 0.1}}).find("smaller than the radius"),
            std::string::npos);
  EXPECT_NE(fault_of("lathe", {{"radii", List{Value(1.0), Value(2.0)}},
                               {"heights", List{Value(0.0), Value(1.0), Value(2.0)}}})
                .find("needs 2 heights, not 3"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::field
