// SPDX-License-Identifier: Apache-2.0
// Each gate on a view that passes all of them but for one property.
#include "synthetic.h"

#include <gtest/gtest.h>
#include <vug/scout/gates.h>

#include <algorithm>
#include <cmath>

namespace vug::scout {
namespace {

/// The normals of a wall that is bent: no two columns are parallel within 10 degrees.
Vec3f bent(double u) {
  const double angle = 12 * u;
  return Vec3f(static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle)));
}

/// A floor below, a bent wall above, 5 to 10 m away.
Seen fine(double u, double v) { return v > 0.75 ? surface(5, {0, 1, 0}) : surface(10, bent(u)); }

std::vector<Gate> gates(const View& view, double clearance = 1) {
  return failed_gates(view, clearance);
}

TEST(Gates, AWellComposedViewPasses) { EXPECT_TRUE(gates(view_of(fine)).empty()); }

TEST(Gates, AnEyeAtAWall) { EXPECT_EQ(gates(view_of(fine), 0.2), std::vector{Gate::clearance}); }

TEST(Gates, OnePixelThatIsTooNear) {
  View view = view_of(fine);
  view.at(3, 3).distance = 0.6f;
  EXPECT_EQ(gates(view), std::vector{Gate::nearest});
}

TEST(Gates, AnObstructionOfAQuarter) {
  const auto blocked = [](double share) {
    return view_of([&](double u, double v) {
      Seen seen = fine(u, v);
      if (u < share) seen.distance = 1.5f;
      return seen;
    });
  };
  EXPECT_TRUE(gates(blocked(0.24)).empty());
  EXPECT_EQ(gates(blocked(0.26)), std::vector{Gate::obstruction});
}

TEST(Gates, AFlatWall) {
  const auto walled = [](double share) {
    return view_of([&](double u, double v) {
      return u < share && v <= 0.75 ? surface(10, {0, 0, 1}) : fine(u, v);
    });
  };
  EXPECT_TRUE(gates(walled(0.5)).empty());
  EXPECT_EQ(gates(walled(0.7)), std::vector{Gate::flat});
}

TEST(Gates, AShallowView) {
  EXPECT_TRUE(gates(view_of(fine), 2.4).empty());
  EXPECT_EQ(gates(view_of(fine), 2.6), std::vector{Gate::shallow});
}

TEST(Gates, TheShareOfTheFloor) {
  const auto floored = [](double from) {
    return view_of([&](double u, double v) {
      return v > from ? surface(5 + u, {0, 1, 0}) : surface(10, bent(u));
    });
  };
  EXPECT_EQ(gates(floored(0.95)), std::vector{Gate::floor});
  EXPECT_TRUE(gates(floored(0.6)).empty());
  const std::vector<Gate> much = gates(floored(0.4));
  EXPECT_NE(std::find(much.begin(), much.end(), Gate::floor), much.end());
}

TEST(Gates, TheShareOfTheSky) {
  const auto opened = [](double share) {
    return view_of([&](double u, double v) { return u < share ? Seen() : fine(u, v); });
  };
  EXPECT_TRUE(gates(opened(0.2)).empty());
  EXPECT_EQ(gates(opened(0.3)), std::vector{Gate::sky});
  GateLimits dark;
  dark.sky_shines = false;
  EXPECT_EQ(failed_gates(opened(0.1), 1, dark), std::vector{Gate::sky}) << "a black hole";
  EXPECT_TRUE(failed_gates(view_of(fine), 1, dark).empty());
  EXPECT_TRUE(failed_gates(opened(0.015), 1, dark).empty()) << "the dark end of a passage";
}

TEST(Gates, NoShotIsInAWallOrShowsAHole) {
  for (const Gate strict : {Gate::clearance, Gate::nearest, Gate::sky})
    EXPECT_TRUE(is_strict(strict)) << gate_text(strict);
  for (const Gate other : {Gate::obstruction, Gate::flat, Gate::shallow, Gate::floor})
    EXPECT_FALSE(is_strict(other)) << gate_text(other);
}

TEST(Gates, ThePlaneIsConnectedAndOfOneNormal) {
  const View halves = view_of([](double u, double) {
    return surface(5, u < 0.3 || u > 0.6 ? Vec3f(1, 0, 0) : Vec3f(0, 0, 1));
  });
  EXPECT_NEAR(largest_plane(halves), 0.4, 0.02) << "the left and the right part are not connected";
  EXPECT_EQ(largest_plane(view_of([](double, double) { return Seen(); })), 0) << "the sky";
}

}  // namespace
}  // namespace vug::scout
