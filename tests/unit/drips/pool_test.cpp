// SPDX-License-Identifier: Apache-2.0
// Basins fill to the lowest point of their rim.
#include <vug/drips/basin.h>
#include <vug/field/affine.h>

#include <gtest/gtest.h>

#include "rooms.h"

namespace vug::drips {
namespace {

/// A floor at the height 0 that ends at a cliff, with a bowl 20 cm deep, and a notch in its rim.
field::Field bowl(double notch) {
  const auto box = [](const Vec3d& size, const Vec3d& centre) {
    return field::transformed(field::make("box", {{"size", size}}), Transform::translation(centre));
  };
  const field::Field floor = box({4, 2, 4}, {0, -1, 0});
  const field::Field hollow = field::make("ellipsoid", {{"radii", Vec3d(1, 0.2, 1)}});
  return field::subtract(floor, {hollow, box({2.2, 2 * notch, 0.4}, {1.1, 0, 0})});
}

TEST(Basin, FillsToItsLip) {
  const auto basin = basin_at(bowl(0.08), {0, -0.2, 0}, {.cell = 0.05});
  ASSERT_TRUE(basin);
  EXPECT_NEAR(basin->level, -0.08, 1e-6);
  // The ellipse in which the bowl is deeper than the notch.
  EXPECT_NEAR(basin->area, kPi * (1 - 0.16), 0.5);
  EXPECT_GT(basin->spill.x, 1.9) << "it runs over through the notch";
  EXPECT_LT(basin->spill.y, -0.08);
}

TEST(Basin, IsNoneOnASlopeOrIfOpen) {
  const field::Field slope = field::make("half_space", {{"normal", Vec3d(0.3, 1, 0)}});
  EXPECT_FALSE(basin_at(slope, {0, 0, 0}, {}));
  EXPECT_FALSE(basin_at(bowl(0.08), {0, -0.2, 0}, {.most = 20}));
  BasinOptions small;
  small.region = Box3d(Vec3d(-0.5), Vec3d(0.5));
  EXPECT_FALSE(basin_at(bowl(0.08), {0, -0.2, 0}, small));
}

}  // namespace
}  // namespace vug::drips
