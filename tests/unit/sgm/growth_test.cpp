// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace vug::sgm {
namespace {

Growth started(const Field& f, const Options& options = {}) {
  Growth growth(options);
  growth.apply(step(Operation::unite, f), RandomKey(0));
  return growth;
}

std::optional<Bond> free_on(const Growth& growth, Label side) {
  for (const Bond& bond : growth.free_bonds())
    if (on_side(bond, side)) return bond;
  return std::nullopt;
}

TEST(Growth, TheFirstShapeStartsTheBaseWhateverItsOperation) {
  for (const Operation operation :
       {Operation::unite, Operation::subtract, Operation::intersect, Operation::morph}) {
    Growth growth;
    const Placement& first = growth.apply(step(operation, ball(1)), RandomKey(1));
    EXPECT_TRUE(first.effective);
    EXPECT_FALSE(first.glued);
    EXPECT_EQ(first.note, "starts the base");
    EXPECT_EQ(growth.field().value({0, 0, 0}), -1);
    EXPECT_EQ(growth.free_bonds().size(), 6u);
  }
}

TEST(Growth, WithoutOverlapWallsTouchAtTheLabel) {
  Options options;
  options.overlap.unite = 0;
  for (int s = 0; s < 6; ++s) {
    const Label side = static_cast<Label>(s);
    Growth growth = started(ball(1), options);
    const Placement& done = growth.apply(step(Operation::unite, ball(2), side), RandomKey(1));
    EXPECT_TRUE(done.glued);
    EXPECT_EQ(done.press, 0);
    EXPECT_LT((done.base_bond.point - direction(side)).length(), 1e-12);
    EXPECT_LT((done.map.point(Vec3d(0)) - direction(side) * 3.0).length(), 1e-12);
  }
}

TEST(Growth, BallsInARowOverlapByTheFractionOfTheirExtent) {
  Growth growth = started(ball(1));
  const double pitch = 2 - 0.3 * 2;
  std::set<int> ids;
  for (int i = 1; i <= 5; ++i) {
    const Placement& done = growth.apply(step(Operation::unite, ball(1)), RandomKey(2).at("n"));
    EXPECT_NEAR(done.map.point(Vec3d(0)).x, pitch * i, 1e-9);
    EXPECT_TRUE(ids.insert(done.base_bond_id).second);
    // Six bonds per ball, two of them consumed by every label.
    EXPECT_EQ(growth.free_bonds().size(), static_cast<size_t>(6 + 4 * i));
  }
  EXPECT_NEAR(free_on(growth, Label::plus_x)->point.x, 5 * pitch + 1, 1e-9);
  EXPECT_NEAR(free_on(growth, Label::minus_x)->point.x, -1, 1e-9);
}

TEST(Growth, CoveredBondsMoveToTheNewSurface) {
  Growth growth = started(ball(0.2));
  growth.apply(step(Operation::unite, ball(2)), RandomKey(1));  // centre at 0.2 + 2 - 0.3 * 4 = 1
  EXPECT_NEAR(free_on(growth, Label::minus_x)->point.x, -1, 1e-9);
  for (const Bond& bond : growth.free_bonds())
    EXPECT_NEAR(growth.field().value(bond.point), 0, 1e-9);
  const Bond top = *free_on(growth, Label::plus_y);
  EXPECT_NEAR(top.point.x, 0, 1e-12);
  EXPECT_NEAR(top.point.y, std::sqrt(3), 1e-9);
}

TEST(Growth, ADifferenceCutsANicheAndLeavesABondAtItsBottom) {
  Growth growth = started(box({1, 1, 1}));
  const Placement& cut = growth.apply(step(Operation::subtract, ball(0.5)), RandomKey(1));
  EXPECT_NEAR(cut.map.point(Vec3d(0)).x, 1 + 0.5 - 0.3 * 1, 1e-9);
  EXPECT_GT(growth.field().value({0.9, 0, 0}), 0);
  EXPECT_LT(growth.field().value({0.6, 0, 0}), 0);
  EXPECT_NEAR(free_on(growth, Label::plus_x)->point.x, 0.7, 1e-9);
  EXPECT_EQ(growth.free_bonds().size(), 6u);
}

TEST(Growth, ALocalIntersectionShapesTheEndAndLeavesTheRest) {
  Growth growth = started(box({5, 1, 1}));
  growth.apply(step(Operation::intersect, ball(1.2)), RandomKey(1));
  const double centre = 5 + 1.2 - 0.75 * 2.4;
  EXPECT_LT(growth.field().value({-4.9, 0.9, 0.9}), 0);
  EXPECT_LT(growth.field().value({centre - 0.1, 0.9, 0.9}), 0);
  EXPECT_GT(growth.field().value({4.9, 0.9, 0.9}), 0);
  EXPECT_LT(growth.field().value({4.9, 0, 0}), 0);
}

TEST(Growth, TheWholeIntersectionIsTheLiteralOne) {
  Options options;
  options.reach = Reach::whole;
  Growth growth = started(box({5, 1, 1}), options);
  const Placement done = growth.apply(step(Operation::intersect, ball(1.2)), RandomKey(1));
  for (const Vec3d& p : {Vec3d(-4, 0, 0), Vec3d(4, 0, 0), Vec3d(4.9, 0.9, 0.9)})
    EXPECT_EQ(growth.field().value(p), std::max(box({5, 1, 1}).value(p), done.field.value(p)));
}

TEST(Growth, AnnihilationIsReported) {
  Options options;
  options.reach = Reach::whole;
  options.overlap = {0, 0, 0, 0};  // Walls only touch: there is no common inside.
  Growth growth = started(ball(1), options);
  ProductionStep cut = step(Operation::intersect, ball(1));
  cut.where = {"cave.vug", 7, 3};
  for (int twice = 0; twice < 2; ++twice) {
    const Placement& done = growth.apply(cut, RandomKey(1));
    EXPECT_FALSE(done.effective);
    EXPECT_EQ(done.note, "nothing would remain");
    EXPECT_EQ(growth.field().value(Vec3d(0)), -1);
    EXPECT_EQ(growth.free_bonds().size(), 6u);
  }
  ASSERT_EQ(growth.diagnostics().all().size(), 2u);
  EXPECT_EQ(growth.diagnostics().all()[0].message,
            "intersection with 'shape' has no effect: nothing would remain");
  EXPECT_EQ(growth.diagnostics().all()[0].where.line, 7);

  // A cut around the whole base.
  Growth other = started(ball(1));
  ProductionStep all = step(Operation::subtract, ball(5));
  all.overlap = 0.1;
  EXPECT_TRUE(other.apply(all, RandomKey(1)).effective);
  all.overlap = 0.8;
  EXPECT_FALSE(started(ball(1)).apply(all, RandomKey(1)).effective);
}

TEST(Growth, EmptyShapesHaveNoEffect) {
  Growth growth = started(ball(1));
  EXPECT_EQ(growth.apply(step(Operation::unite, Field()), RandomKey(1)).note, "the shape is empty");
  EXPECT_EQ(growth.diagnostics().all().size(), 1u);
}

TEST(Growth, ABondWithoutDirectionJoinsOnceOnAnySide) {
  const double h = std::sqrt(0.5);
  Growth growth = started(solid(TestHalfSpace{{h, h, 0}}));
  EXPECT_TRUE(growth.apply(step(Operation::unite, ball(1), Label::minus_z), RandomKey(1)).glued);
  // Five bonds of the ball are free now; +Z, where it was glued, has none left.
  EXPECT_TRUE(growth.apply(step(Operation::unite, ball(1), Label::plus_y), RandomKey(1)).effective);
}

TEST(Growth, ASideWithoutBondsHasNone) {
  Growth growth = started(solid(TestHalfSpace{{0, 1, 0}}));
  const Placement& done = growth.apply(step(Operation::unite, ball(1)), RandomKey(1));
  EXPECT_FALSE(done.effective);
  EXPECT_EQ(done.note, "side +X has no free bond");
}

TEST(Growth, RotatesShapesThatFaceAnotherDirection) {
  // The ground's wall faces up; glued to the right side of the ball it faces left.
  Growth growth = started(ball(1));
  const Placement& done =
      growth.apply(step(Operation::unite, solid(TestHalfSpace{{0, 1, 0}})), RandomKey(1));
  EXPECT_TRUE(makes_label(done.base_bond, done.shape_bond, 1));
  EXPECT_NEAR(growth.field().value({3, 5, 0}), -2, 1e-9);  // solid beyond x = 1
}

TEST(Growth, AProductionNeedsAShape) {
  EXPECT_THROW(Growth().apply(ProductionStep{}, RandomKey(1)), Error);
}

}  // namespace
}  // namespace vug::sgm
