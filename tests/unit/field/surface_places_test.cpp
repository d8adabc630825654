// SPDX-License-Identifier: Apache-2.0
// Places on surfaces, and unions of many small elements.
#include "scatter_fixture.h"

#include <vug/base/parallel.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/registry.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/lobe.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::field {
namespace {

Vec3d random_in_box(RandomStream& random, double half) {
  const double x = random.uniform(-half, half), y = random.uniform(-half, half);
  return {x, y, random.uniform(-half, half)};
}

TEST(ElementField, HasTheDistancesOfThePlainUnion) {
  RandomStream random(RandomKey(3));
  std::vector<Lobe> lobes;
  for (int i = 0; i < 500; ++i)
    lobes.push_back({random_in_box(random, 1), random.uniform(0.01, 0.2)});
  const Blend fillet{Profile::smooth, 0.1};
  const Field sharp = element_field("lobes", lobes, Exactness::exact);
  const Field smooth = element_field("lobes", lobes, Exactness::exact, fillet);
  for (int i = 0; i < 3000; ++i) {
    const Vec3d p = random_in_box(random, 2);
    std::vector<double> all;
    for (const Lobe& lobe : lobes) all.push_back(lobe.distance(point(p)));
    std::sort(all.begin(), all.end());
    EXPECT_EQ(sharp.value(p), all[0]);
    EXPECT_EQ(smooth.value(p), fillet.smin(all[0], all[1]));
  }
  EXPECT_EQ(element_field("lobes", std::vector<Lobe>(), Exactness::exact).value({0, 0, 0}), 1e6);
}

TEST(ElementField, IsTheSameInAPartOfSpaceOneByOneAndEightByEight) {
  RandomStream random(RandomKey(4));
  std::vector<Lobe> lobes;
  for (int i = 0; i < 2000; ++i)
    lobes.push_back({random_in_box(random, 1), random.uniform(0.005, 0.03)});
  for (const double radius : {0.0, 0.02}) {
    const Field whole =
        element_field("lobes", lobes, Exactness::exact, Blend{Profile::smooth, radius});
    Scratch scratch;
    for (int round = 0; round < 200; ++round) {
      const Ball ball{random_in_box(random, 1), std::exp2(random.uniform(-8, -3))};
      const Field::RestrictedField part = whole.restricted(ball);
      EXPECT_NE(part.field.node(), whole.node());
      float xyz[3][Pack::kLanes], values[Pack::kLanes], slopes[Pack::kLanes];
      for (int lane = 0; lane < Pack::kLanes; ++lane) {
        const Vec3d p = ball.centre + random_in_box(random, 0.57 * ball.radius);
        EXPECT_EQ(part.field.value(p), whole.value(p));
        EXPECT_EQ(part.field.gradient(p).gradient, whole.gradient(p).gradient);
        for (int axis = 0; axis < 3; ++axis) xyz[axis][lane] = static_cast<float>(p[axis]);
      }
      const Point<Pack> points{Pack::load(xyz[0]), Pack::load(xyz[1]), Pack::load(xyz[2])};
      Pack out;
      Dual<Pack> steep;
      part.field.values(&points, 1, &out, scratch);
      part.field.gradients(&points, 1, &steep, scratch);
      out.store(values);
      steep.dx.store(slopes);
      for (int lane = 0; lane < Pack::kLanes; ++lane) {
        const Vec3d p(Vec3f(xyz[0][lane], xyz[1][lane], xyz[2][lane]));
        EXPECT_NEAR(static_cast<double>(values[lane]), whole.value(p), 1e-6);
        EXPECT_NEAR(static_cast<double>(slopes[lane]), whole.gradient(p).gradient.x, 2e-3);
      }
    }
  }
}

TEST(SurfacePlaces, CoverTheSurfaceEvenly) {
  const double radius = 0.8, spacing = 0.05;
  for (const Field& rock :
       {make("sphere", {{"radius", radius}}), complement(make("sphere", {{"radius", radius}}))}) {
    const auto places = find_surface_places(scatter_on(rock, 1, spacing));
    const double area = 4 * kPi * radius * radius;
    EXPECT_NEAR(static_cast<double>(places.size()) * spacing * spacing / area, 1, 0.1);
    int octants[8] = {};
    for (const SurfacePlace& place : places) {
      EXPECT_NEAR(place.at.length(), radius, 1e-6);
      EXPECT_NEAR(std::fabs(place.normal.dot(place.at)) / radius, 1, 1e-6);
      EXPECT_GT(rock.value(place.at + place.normal * 0.01), 0);
      ++octants[(place.at.x > 0) + 2 * (place.at.y > 0) + 4 * (place.at.z > 0)];
    }
    for (const int each : octants)
      EXPECT_NEAR(each, static_cast<double>(places.size()) / 8,
                  0.08 * static_cast<double>(places.size()) / 8);
    for (size_t i = 0; i < places.size(); ++i)
      for (size_t k = 0; k < i; ++k)
        ASSERT_GE((places[i].at - places[k].at).length(), 0.7 * spacing);
  }
}

TEST(SurfacePlaces, DependNeitherOnThreadsNorOnTheBox) {
  const Field rock = make("box", {{"size", Vec3d(1.2, 0.9, 1.1)}});
  const SurfaceScatter scatter = scatter_on(rock, 1, 0.04);
  const auto one = with_threads(1, [&] { return find_surface_places(scatter); });
  for (const int threads : {2, 7}) {
    const auto many = with_threads(threads, [&] { return find_surface_places(scatter); });
    ASSERT_EQ(many.size(), one.size());
    for (size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(many[i].at, one[i].at);
      EXPECT_EQ(many[i].key.state(), one[i].key.state());
    }
  }
}

TEST(SurfacePlaces, AreRarerWhereTheMaskIsLow) {
  SurfaceScatter scatter = scatter_on(make("half_space"), 1, 0.03);
  const size_t all = find_surface_places(scatter).size();
  scatter.where = make_noise("joints", {{"spacing", 0.5}, {"width", 0.08}});
  const size_t masked = find_surface_places(scatter).size();
  EXPECT_LT(masked, all);
  EXPECT_GT(masked, all / 3);  // 0 means half of the candidates.
}

TEST(SurfacePlaces, RefuseRequestsForTooManyForms) {
  const auto spar = [](double spacing) {
    return make("dogtooth_spar", {{"field", as_value(make("half_space"))},
                                  {"from", Vec3d(-5, -0.1, -5)},
                                  {"to", Vec3d(5, 0.1, 5)},
                                  {"spacing", spacing}});
  };
  try {
    spar(0.004);
    ADD_FAILURE() << "12 million crystals are accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    EXPECT_NE(std::string(error.what()).find("larger spacing"), std::string::npos);
  }
  try {  // 0.2 million crystals of over 200 bytes.
    compute_deferred(spar(0.03), Progress::none(), 20'000'000);
    ADD_FAILURE() << "no limit";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
  }
}

TEST(Exposure, IsThatOfPlanesTipsAndHollows) {
  const SurfacePlace top{{0, 0, 0}, {0, 1, 0}, RandomKey(1)};
  EXPECT_NEAR(exposure(make("half_space"), top, 0.05), 0, 1e-9);
  const auto ball = [](double radius) {
    return Field(make(
        "capsule", {{"a", Vec3d(0, -radius, 0)}, {"b", Vec3d(0, -radius, 0)}, {"radius", radius}}));
  };
  EXPECT_GT(exposure(ball(1e-4), top, 0.05), 0.95);
  EXPECT_GT(exposure(ball(0.05), top, 0.05), 0.3);
  const Field hollow = complement(
      make("capsule", {{"a", Vec3d(0, 0.05, 0)}, {"b", Vec3d(0, 0.05, 0)}, {"radius", 0.05}}));
  EXPECT_LT(exposure(hollow, top, 0.05), -0.3);
}

}  // namespace
}  // namespace vug::field
