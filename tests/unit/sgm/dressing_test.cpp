// SPDX-License-Identifier: Apache-2.0
// Steps with a frame, with a heading and with limits.
#include <gtest/gtest.h>
#include <vug/field/registry.h>
#include <vug/sgm/growth.h>
#include <vug/sgm/named_places.h>

#include <cmath>

namespace vug::sgm {
namespace {

ProductionStep step_of(const std::string& kind, Operation operation = Operation::unite) {
  ProductionStep step;
  step.operation = operation;
  step.label = Label::plus_x;
  step.pieces = {{kind, field::make(kind)}};
  return step;
}

TEST(Dressing, AFramePutsTheShapeThere) {
  Growth growth;
  growth.apply(step_of("sphere"), RandomKey(1));
  ProductionStep placed = step_of("box");
  placed.frame = Transform::translation({10, 0, 0});
  placed.name = "box";
  const Placement& placement = growth.apply(placed, RandomKey(2));
  EXPECT_FALSE(placement.glued);
  EXPECT_EQ(placement.middle(), Vec3d(10, 0, 0));
  EXPECT_LT(growth.field().value({10, 0, 0}), 0);
  EXPECT_GT(growth.field().value({5, 0, 0}), 0);
}

TEST(Dressing, PlacedShapesTakeEffectInOrder) {
  Growth growth;
  growth.apply(step_of("box"), RandomKey(1));
  ProductionStep hole = step_of("sphere", Operation::subtract);
  hole.frame = Transform();
  growth.apply(hole, RandomKey(2));
  EXPECT_GT(growth.field().value({0, 0, 0}), 0);
  ProductionStep plug = step_of("sphere");
  plug.frame = Transform();
  growth.apply(plug, RandomKey(3));
  growth.apply(plug, RandomKey(4));
  EXPECT_LT(growth.field().value({0, 0, 0}), 0);
  growth.apply(hole, RandomKey(5));
  EXPECT_GT(growth.field().value({0, 0, 0}), 0);
}

TEST(Dressing, PlacedShapesAreThereWhenOthersAreGlued) {
  Growth growth;
  growth.apply(step_of("box"), RandomKey(1));
  ProductionStep longer = step_of("box");
  longer.frame = Transform::translation({0.5, 0, 0});
  growth.apply(longer, RandomKey(2));
  ProductionStep cut = step_of("sphere", Operation::subtract);
  cut.frame = Transform::translation({0.5, 0, 0});
  growth.apply(cut, RandomKey(3));
  const Placement& glued = growth.apply(step_of("box"), RandomKey(4));
  ASSERT_TRUE(glued.effective);
  EXPECT_GT(glued.middle().x, 0.5) << "on the wall that the placed box moved";
}

TEST(Dressing, ASlopeTurnsTheDirection) {
  Heading heading;
  EXPECT_EQ(heading.turned({1, 0, 0}), Vec3d(1, 0, 0));
  heading.slope = -0.5;
  const Vec3d down = heading.turned({0.6, 0.8, 0});
  EXPECT_NEAR(down.x, std::cos(0.5), 1e-12);
  EXPECT_NEAR(down.y, -std::sin(0.5), 1e-12);
  EXPECT_EQ(heading.turned({0, -1, 0}), Vec3d(0, -1, 0)) << "a vertical direction does not turn";
}

TEST(Dressing, AnAzimuthIsThatOfTheNearestJoint) {
  Heading heading;
  heading.azimuths = {0, kPi / 2};  // north-south and east-west
  const Vec3d east = heading.turned(Vec3d(0.9, 0, -0.3).normalized());
  EXPECT_NEAR(east.x, 1, 1e-12);
  const Vec3d south = heading.turned(Vec3d(0.3, 0, 0.9).normalized());
  EXPECT_NEAR(south.z, 1, 1e-12);
  const Vec3d steep = heading.turned({0.1, std::sqrt(1 - 0.02), 0.1});
  EXPECT_NEAR(steep.length(), 1, 1e-12);
}

TEST(Dressing, GluedShapesFollowTheHeading) {
  Growth growth;
  growth.apply(step_of("sphere"), RandomKey(1));
  ProductionStep level = step_of("box");
  level.heading.slope = 0.4;
  const Placement& placement = growth.apply(level, RandomKey(2));
  ASSERT_TRUE(placement.effective);
  EXPECT_NEAR(placement.heading.y, std::sin(0.4), 1e-12);
  EXPECT_GT(placement.middle().y, 0.05);
}

TEST(Dressing, LimitsRefuseWithoutAWarning) {
  Growth growth;
  growth.apply(step_of("sphere"), RandomKey(1));
  ProductionStep outside = step_of("sphere");
  outside.limits.within = field::make("sphere");
  const Placement& placement = growth.apply(outside, RandomKey(2));
  EXPECT_FALSE(placement.effective);
  EXPECT_TRUE(placement.refused);
  EXPECT_TRUE(growth.diagnostics().all().empty());
  EXPECT_TRUE(growth.apply(step_of("sphere"), RandomKey(3)).effective) << "the bond is still free";
}

TEST(Dressing, ShapesKeepApartFromAllButTheirNeighbours) {
  Growth growth;
  growth.apply(step_of("sphere"), RandomKey(1));
  ProductionStep other = step_of("sphere");
  other.frame = Transform::translation({4.5, 0, 0});
  growth.apply(other, RandomKey(2));
  ProductionStep glued = step_of("sphere");
  glued.limits.apart = 2;
  EXPECT_TRUE(growth.apply(glued, RandomKey(3)).refused) << "the gap is less than 2 m";
  glued.limits.apart = 0.5;
  EXPECT_TRUE(growth.apply(glued, RandomKey(4)).effective) << "its own neighbour does not count";
}

TEST(Dressing, PlacesBelongToTheResultOnly) {
  const field::Field plain = field::make("sphere");
  const field::Field named = with_places(plain, {{"hall", {1, 2, 3}}});
  ASSERT_EQ(places_of(named).size(), 1u);
  EXPECT_EQ(places_of(named)[0].name, "hall");
  EXPECT_TRUE(places_of(plain).empty());
  for (const Vec3d& p : {Vec3d(0, 0, 0), Vec3d(0.3, 1, 2)}) {
    EXPECT_EQ(named.value(p), plain.value(p));
    EXPECT_EQ(named.gradient(p).gradient, plain.gradient(p).gradient);
    EXPECT_EQ(named.restricted({p, 0.1}).range.lo, plain.restricted({p, 0.1}).range.lo);
  }
  EXPECT_EQ(to_string(named), to_string(plain));
}

}  // namespace
}  // namespace vug::sgm
