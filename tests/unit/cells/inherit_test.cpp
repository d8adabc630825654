// SPDX-License-Identifier: Apache-2.0
// Attributes of cells that new cells on a grown surface inherit.
#include "run.h"

#include <vug/cells/inherit.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::cells {
namespace {

NetworkPtr ball(double radius, double spacing) {
  const Surface surface({shared(mesh::sphere_mesh(Vec3d(0), radius, 4))});
  return std::make_shared<const Network>(build(surface, options("random", spacing)).network);
}

/// A ball whose cells have risen by 20 cm, which is more than their reach, and new cells there.
struct GrownBall {
  Simulation before{ball(1, 0.08), RandomKey(1)}, after{ball(1.2, 0.08), RandomKey(2)};

  GrownBall() {
    Attributes& all = before.attributes();
    all.column<float>("height", 0.2f);
    all.column<float>("even", 0.7f);
    all.column<int32_t>("seed", 5);
    auto& east = all.column<float>("east").now;
    auto& normal = all.column<Vec3f>("color").now;
    for (size_t i = 0; i < east.size(); ++i) {
      east[i] = 1.2f * before.network().position[i].x;
      normal[i] = before.network().normal[i];
    }
  }
};

TEST(Inherit, TakesWhatTheCellsHaveWhereTheyAreNow) {
  GrownBall grown;
  inherit_attributes(grown.before, grown.after);
  const Attributes& all = grown.after.attributes();
  EXPECT_FALSE(all.find("height"));
  for (size_t i = 0; i < grown.after.network().size(); ++i) {
    const Vec3f& p = grown.after.network().position[i];
    ASSERT_EQ(all.values<float>("even")[i], 0.7f);
    ASSERT_EQ(all.values<int32_t>("seed")[i], 5);
    ASSERT_NEAR(all.values<float>("east")[i], p.x, 0.05f);
    ASSERT_LT((all.values<Vec3f>("color")[i] - grown.after.network().normal[i]).length(), 0.08f);
  }
}

TEST(Inherit, KeepsCellsRemoved) {
  GrownBall grown;
  std::vector<CellState> states = grown.before.states();
  for (size_t i = 0; i < states.size(); ++i)
    if (grown.before.network().position[i].y > 0.5f) states[i] = CellState::transparent;
  grown.before.set_states(states);
  inherit_attributes(grown.before, grown.after);
  for (size_t i = 0; i < grown.after.network().size(); ++i) {
    const float y = grown.after.network().position[i].y;
    if (std::fabs(y - 0.6f) > 0.1f) {
      ASSERT_EQ(grown.after.states()[i] == CellState::transparent, y > 0.6f) << y;
    }
  }
}

}  // namespace
}  // namespace vug::cells
