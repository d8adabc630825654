// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <gtest/gtest.h>

namespace vug::sgm {
namespace {

Geology strata() {
  return {{{"shale", moved(box({100, 1, 100}), {0, 1, 0}), 0.1, 0.2},
           {"limestone", solid(TestHalfSpace{{0, 1, 0}}), 0.5, 1.0}}};
}

TEST(Geology, MapsTheAmountToTheRangeOfTheRock) {
  const Geology g = strata();
  EXPECT_DOUBLE_EQ(g.amount_at({0, 1, 0}, 0.5), 0.15);
  EXPECT_DOUBLE_EQ(g.amount_at({0, -3, 0}, 0.5), 0.75);
  EXPECT_DOUBLE_EQ(g.amount_at({0, -3, 0}, 0), 0.5);
  EXPECT_DOUBLE_EQ(g.amount_at({0, -3, 0}, 1), 1);
  EXPECT_DOUBLE_EQ(g.amount_at({0, 9, 0}, 0.5), 0.5);  // between the components
  EXPECT_EQ(g.at({0, 1, 0})->name, "shale");
  EXPECT_EQ(g.at({0, 9, 0}), nullptr);
}

TEST(Geology, DecidesWhatAMorphDoes) {
  Options options;
  options.geology = strata();
  for (const double height : {1.0, -5.0}) {
    Growth growth(options);
    growth.apply(step(Operation::unite, moved(ball(1), {0, height, 0})), RandomKey(1));
    ProductionStep melt = step(Operation::morph, ball(1));
    melt.amount = 0.52;
    const Placement& done = growth.apply(melt, RandomKey(2));
    EXPECT_DOUBLE_EQ(done.amount, height > 0 ? 0.1 + 0.1 * 0.52 : 0.5 + 0.5 * 0.52);
  }
}

TEST(Geology, RefusesInvalidRanges) {
  Options options;
  options.geology.components = {{"marl", Field(), 0.7, 0.2}};
  EXPECT_THROW(Growth{options}, Error);
  options.geology.components = {{"marl", Field(), -0.1, 0.2}};
  EXPECT_THROW(Growth{options}, Error);
}

}  // namespace
}  // namespace vug::sgm
