// SPDX-License-Identifier: Apache-2.0
// Ways through passages: length, ends, corners, and that they stay in the air.
#include "passage_samples.h"

#include <vug/base/error.h>
#include <vug/passages/lines/route.h>
#include <vug/passages/on_axes.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::passages {
namespace {

PassageOptions without_curves() {
  PassageOptions options;
  options.smooth = false;
  return options;
}

TEST(Route, TakesTheShorterWayAroundALoop) {
  const auto loop = network_of({{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 0, 30}, {-5, 0, 0}},
                               {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 0}});
  const Route route(on_axes(loop, without_curves()), 4, 2);
  EXPECT_NEAR(route.length(), 25, 1e-9);
  EXPECT_LT((route.point(0) - Vec3d(-5, 0, 0)).length(), 1e-9);
  EXPECT_LT((route.point(7) - Vec3d(2, 0, 0)).length(), 1e-9);
  EXPECT_LT((route.point(25) - Vec3d(10, 0, 10)).length(), 1e-9);
  EXPECT_LT((route.point(28) - Vec3d(10, 0, 13)).length(), 1e-9);
  EXPECT_LT((route.point(-2) - Vec3d(-7, 0, 0)).length(), 1e-9);
  // The default half width is 0.65 m; a quarter of it is the mean distance to each side.
  EXPECT_NEAR((route.point(15) - Vec3d(10, 0, 0)).length(), 0.25 * 0.65 * std::sqrt(2), 1e-3);
}

TEST(Route, StaysInTheAirOfRandomCaves) {
  for (const uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    const network::Network cave = random_cave(seed, 40);
    const field::Field air = passages(cave);
    const network::Network course = on_axes(cave);
    for (const int to : {9, 25, 40}) {
      const Route route(course, 0, to);
      int outside = 0;
      for (int i = 0; i <= 400; ++i)
        outside += air.value(route.point(route.length() * i / 400)) > 0;
      EXPECT_EQ(outside, 0) << "seed " << seed << " to station " << to;
    }
  }
}

TEST(Route, MovesEvenly) {
  const network::Network cave = random_cave(3, 40);
  const Route route(on_axes(cave), 0, 40);
  const double step = 0.05;
  for (double s = 0; s + step < route.length(); s += step)
    ASSERT_LE((route.point(s + step) - route.point(s)).length(), 1.6 * step) << s;
}

TEST(Route, RefusesCavesThatAreNotConnected) {
  const auto two = network_of({{0, 0, 0}, {10, 0, 0}, {0, 9, 0}, {10, 9, 0}}, {{0, 1}, {2, 3}});
  EXPECT_THROW(Route(on_axes(two), 0, 3), Error);
  EXPECT_THROW(Route(on_axes(network_of({{0, 0, 0}, {1, 0, 0}}, {})), 0, 1), Error);
  const Route nowhere(on_axes(two), 0, 0);
  EXPECT_EQ(nowhere.length(), 0);
  EXPECT_LT((nowhere.point(3) - Vec3d(0, 0, 0)).length(), 1e-9);
}

}  // namespace
}  // namespace vug::passages
