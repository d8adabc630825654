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

TEST(Dressing, LimitsHoldForShapesInFrames) {
  Growth growth;
  growth.apply(step_of("box"), RandomKey(1));
  const auto placed = [&](double x, Operation operation = Operation::unite) {
    ProductionStep step = step_of("sphere", operation);
    step.frame = Transform::translation({x, 0, 0});
    step.limits.apart = 1;
    return growth.apply(step, RandomKey(2));
  };
  EXPECT_TRUE(placed(0).effective) << "the solid that is dressed does not count";
  EXPECT_TRUE(placed(2.5).refused) << "the gap is 0.5 m";
  EXPECT_TRUE(placed(3.5, Operation::subtract).effective);
  EXPECT_TRUE(placed(6, Operation::subtract).refused) << "cuts keep apart, too";
  EXPECT_TRUE(placed(7).effective);
  ProductionStep outside = step_of("sphere");
  outside.frame = Transform::translation({20, 0, 0});
  outside.limits.within = field::make("sphere");
  EXPECT_TRUE(growth.apply(outside, RandomKey(3)).refused);
  EXPECT_GT(growth.field().value({20, 0, 0}), 0);
  EXPECT_TRUE(growth.diagnostics().all().empty());
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

/// A base of a sphere, and spheres of radius 1 m named "a" at 9 m and "b" at the point.
Growth with_ends(const Vec3d& b) {
  Growth growth;
  growth.apply(step_of("sphere"), RandomKey(1));
  for (const auto& [name, at] : {std::pair("a", Vec3d(9, 0, 0)), std::pair("b", b)}) {
    ProductionStep end = step_of("sphere");
    end.frame = Transform::translation(at);
    end.name = name;
    growth.apply(end, RandomKey(2));
  }
  return growth;
}

ProductionStep connecting(const char* kind, const char* from, const char* to) {
  ProductionStep step = step_of(kind);
  step.connect = {from, to};
  return step;
}

TEST(Connections, ExtendFromOneMiddleToTheOther) {
  const Vec3d a(9, 0, 0), b(9, 4, -9);
  Growth growth = with_ends(b);
  const Placement& tube = growth.apply(connecting("sphere", "a", "b"), RandomKey(3));
  ASSERT_TRUE(tube.effective) << tube.note;
  EXPECT_NEAR((tube.middle() - 0.5 * (a + b)).length(), 0, 1e-9);
  const double radius = 1;  // of a sphere without parameters
  const Vec3d along = (b - a).normalized(), across = along.cross({1, 0, 0}).normalized();
  for (int i = -4; i <= 24; ++i) {
    const double at = i / 20.0 * (b - a).length();
    const double past = std::max({0.0, -at, at - (b - a).length()});
    for (const double off : {0.0, 0.7, 1.5}) {
      const double exact = std::hypot(past, off) - radius;
      EXPECT_NEAR(tube.field.value(a + along * at + across * off), exact, 1e-5) << i << " " << off;
    }
    EXPECT_EQ(growth.field().value(a + along * at) < 0, past < radius) << "it is in the base";
  }
}

TEST(Connections, KeepXAlongAndYUp) {
  Growth growth = with_ends({9, 0, 12});
  ProductionStep step = connecting("box", "a", "b");
  step.pieces = {{"box", field::make("box", {{"size", Vec3d(1, 4, 2)}})}};
  const Placement& wall = growth.apply(step, RandomKey(3));
  ASSERT_TRUE(wall.effective);
  EXPECT_NEAR(wall.field.bounds().min.z, -0.5, 1e-4);
  EXPECT_NEAR(wall.field.bounds().max.z, 12.5, 1e-4);
  EXPECT_NEAR(wall.field.bounds().max.y, 2, 1e-4);
  EXPECT_NEAR(wall.field.bounds().max.x, 10, 1e-4);
}

TEST(Connections, ValuesAreBoundsThatPrune) {
  Growth growth = with_ends({14, 9, 3});
  const Placement& found = growth.apply(connecting("torus", "a", "b"), RandomKey(3));
  const field::Field tube = found.field;
  RandomStream random(RandomKey(7));
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p(random.uniform(4, 20), random.uniform(-5, 14), random.uniform(-6, 9));
    const Vec3d q =
        p + 0.5 * Vec3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double value = tube.value(p);
    EXPECT_LE(std::fabs(value - tube.value(q)), (p - q).length() * (1 + 1e-6));
    const double radius = random.uniform(0.1, 2);
    const auto restricted = tube.restricted({p, radius});
    EXPECT_LE(restricted.range.lo, value + 1e-6);
    EXPECT_GE(restricted.range.hi, value - 1e-6);
    EXPECT_NEAR(restricted.field.value(p), value, 1e-6);
    EXPECT_TRUE(value > 0 || tube.bounds().intersects(p));
  }
}

TEST(Connections, OfVerticalPlacesStandUpright) {
  Growth growth = with_ends({9, 8, 0});
  const Placement& shaft = growth.apply(connecting("sphere", "a", "b"), RandomKey(3));
  ASSERT_TRUE(shaft.effective);
  EXPECT_LT(shaft.field.value({9, 4, 0}), 0);
}

TEST(Connections, TakeTheLastPlaceOfAName) {
  Growth growth = with_ends({9, 0, 9});
  ProductionStep again = step_of("sphere");
  again.frame = Transform::translation({20, 0, 0});
  again.name = "a";
  growth.apply(again, RandomKey(4));
  EXPECT_NEAR(growth.apply(connecting("sphere", "a", "b"), RandomKey(5)).middle().x, 14.5, 1e-9);
  // Equal names: the last but one and the last.
  EXPECT_NEAR(growth.apply(connecting("sphere", "a", "a"), RandomKey(6)).middle().x, 14.5, 1e-9);
}

TEST(Connections, WithoutPlacesWarn) {
  Growth growth = with_ends({9, 0, 9});
  const auto note = [&](const ProductionStep& step) {
    const Placement& placement = growth.apply(step, RandomKey(3));
    EXPECT_FALSE(placement.effective);
    EXPECT_FALSE(placement.refused);
    return placement.note;
  };
  EXPECT_EQ(note(connecting("sphere", "a", "lake")), "no earlier shape has the name 'lake'");
  EXPECT_EQ(note(connecting("sphere", "b", "b")), "only one earlier shape has the name 'b'");
  EXPECT_EQ(note(connecting("half_space", "a", "b")), "the shape is infinite");
  EXPECT_EQ(growth.diagnostics().all().size(), 3U);
  Growth same = with_ends({9, 0, 0});
  EXPECT_EQ(same.apply(connecting("sphere", "a", "b"), RandomKey(3)).note,
            "both places are the same point");
}

TEST(Connections, AreLeftOutWithTheirEnds) {
  Growth growth = with_ends({9, 0, 9});
  ProductionStep outside = step_of("sphere");
  outside.limits.within = field::make("sphere");
  outside.name = "b";
  ASSERT_TRUE(growth.apply(outside, RandomKey(3)).refused);
  EXPECT_TRUE(growth.apply(connecting("sphere", "a", "b"), RandomKey(4)).refused)
      << "the earlier shape 'b' is another one";
  EXPECT_TRUE(growth.diagnostics().all().empty());
}

TEST(Connections, HaveLimits) {
  Growth growth = with_ends({9, 0, 9});
  ProductionStep near = connecting("sphere", "a", "b");
  near.limits.apart = 1;
  EXPECT_TRUE(growth.apply(near, RandomKey(3)).effective) << "its ends do not count";
  ProductionStep blocking = step_of("sphere");
  blocking.frame = Transform::translation({10.5, 0, 4.5});
  growth.apply(blocking, RandomKey(4));
  EXPECT_TRUE(growth.apply(near, RandomKey(5)).refused) << "a third shape is in the way";
  near.limits = {field::make("sphere"), 0};
  EXPECT_TRUE(growth.apply(near, RandomKey(6)).refused) << "its middle is outside of 'within'";
}

TEST(Connections, CutAsWell) {
  Growth growth = with_ends({9, 0, 9});
  growth.apply(connecting("sphere", "a", "b"), RandomKey(3));
  ASSERT_LT(growth.field().value({9, 0, 4.5}), 0);
  ProductionStep hole = connecting("sphere", "a", "b");
  hole.operation = Operation::subtract;
  hole.pieces = {{"sphere", field::make("sphere", {{"radius", 0.5}})}};
  EXPECT_TRUE(growth.apply(hole, RandomKey(4)).effective);
  EXPECT_NEAR(growth.field().value({9, 0, 4.5}), 0.5, 1e-5);
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
