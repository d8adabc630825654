// SPDX-License-Identifier: Apache-2.0
// A deferred field is its result: computed once, on demand, from any number of threads.
#include <vug/base/parallel.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/fold_operand.h>
#include <vug/field/operands.h>
#include <vug/field/registry.h>

#include <gtest/gtest.h>

#include <atomic>

namespace vug::field {
namespace {

TEST(Deferred, IsComputedOnceWhenAValueIsNeeded) {
  const Field ball = make("sphere", {{"radius", 2.0}});
  static std::atomic<int> calls = 0;
  static std::atomic<double> sum = 0;
  const auto dig = [](const Field& solid) {
    ++calls;
    // A parallel loop of its own, while others wait for the field.
    sum = ordered_sum(
        20000, 0.0, [&](size_t i) { return solid.value(Vec3d(double(i), 0, 0)); }, 8);
    return solid;
  };
  const Field field = deferred(ball.node()->traits(), {"digging"}, dig, ball);
  EXPECT_EQ(field.lipschitz(), 1);
  EXPECT_EQ(field.bounds(), ball.bounds());
  EXPECT_EQ(calls, 0);
  std::vector<double> values(4000);
  with_threads(7, [&] {
    parallel_for(values.size(), [&](size_t i) { values[i] = field.value(Vec3d(0, double(i), 0)); });
    EXPECT_EQ(calls, 1);
    for (size_t i = 0; i < values.size(); ++i) ASSERT_EQ(values[i], double(i) - 2);
    EXPECT_EQ(to_string(field), to_string(ball));
    const Ball region{Vec3d(0, 3, 0), 0.5};
    EXPECT_EQ(field.restricted(region).range.lo, ball.restricted(region).range.lo);
    EXPECT_EQ(field.restricted(region).range.hi, ball.restricted(region).range.hi);
  });
}

TEST(Deferred, BoundsAndInspectionComputeNothing) {
  const Field ball = make("sphere", {{"radius", 2.0}});
  static int calls = 0;
  const auto dig = [](const Field& solid) {
    ++calls;
    return solid;
  };
  const Field drips = deferred(ball.node()->traits(), {"digging"}, dig, ball);
  const Field rock = unite({make("box"), drips});
  EXPECT_EQ(to_string(rock), "union\n  box\n  deferred\n");
  EXPECT_EQ(node_count(rock), 3u);
  const Interval inside = bounds_at(rock, Vec3d(0.1));  // in the box, in which nothing is removed
  EXPECT_LT(inside.hi, 0);
  const Interval unknown = bounds_at(rock, Vec3d(1.5, 0, 0));
  EXPECT_LT(unknown.lo, 0);
  EXPECT_GT(unknown.hi, 0);
  EXPECT_NEAR(bounds_at(rock, Vec3d(5, 0, 0)).lo, 3, 1e-9);  // the distance to the ball's box
  EXPECT_EQ(calls, 0);
  EXPECT_LT(rock.value(Vec3d(1.5, 0, 0)), 0);
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(bounds_at(rock, Vec3d(1.5, 0, 0)).contains(rock.value(Vec3d(1.5, 0, 0))));
}

// Promised bounds hold for all results that are possible; those of the result exclude more.
TEST(Deferred, MovedOperandsHaveTheBoundsOfTheResult) {
  const Field ball = make("sphere", {{"radius", 2.0}});
  const auto dig = [](const Field& solid) { return solid; };
  Traits wide{8, Exactness::sign, Box3d(Vec3d(-20.0), Vec3d(20.0)), 0.5};
  const Field digging = deferred(wide, {"digging"}, dig, ball);
  const Operand operand(digging.node(), 1);
  EXPECT_EQ(operand.reach.box, wide.bounds);
  const Operand moved = operand.translated({1, 2, 3});
  EXPECT_EQ(moved.reach.box, Box3d(Vec3d(-1, 0, 1), Vec3d(3, 4, 5)));
  EXPECT_EQ(moved.reach.growth, 1);
  // A result without bounds keeps those that were promised.
  const Field endless = deferred(wide, {"digging"}, dig, make("half_space"));
  EXPECT_EQ(Operand(endless.node(), 1).translated({1, 2, 3}).reach.box,
            Box3d(Vec3d(-19, -18, -17), Vec3d(21, 22, 23)));
}

TEST(Deferred, IsComputedAsAStageAndOnlyOnce) {
  const Field ball = make("sphere", {{"radius", 2.0}});
  const Field field = unite({ball, deferred(
                                       ball.node()->traits(), {"digging"},
                                       [](const Field& solid) { return solid; }, ball)});
  std::vector<std::string> stages;
  Progress progress([&](const std::string& stage, double fraction) {
    if (fraction >= 1) stages.push_back(stage);
  });
  for (int i = 0; i < 2; ++i) compute_deferred(field, progress);
  EXPECT_EQ(stages, std::vector<std::string>{"digging"});
}

TEST(Deferred, IsRefusedIfItNeedsTooMuchMemory) {
  const Field ball = make("sphere", {{"radius", 2.0}});
  static int calls = 0;
  const auto dig = [](const Field& solid) {
    ++calls;
    return solid;
  };
  const Field field = deferred(ball.node()->traits(), {"digging", 1000}, dig, ball);
  EXPECT_THROW(compute_deferred(field, Progress::none(), 999), Error);
  EXPECT_EQ(calls, 0);
  compute_deferred(field, Progress::none(), 1000);
  EXPECT_EQ(calls, 1);
}

TEST(Deferred, AnErrorIsRepeated) {
  const Field field =
      deferred({}, {"digging"}, []() -> Field { throw Error(ErrorCode::bad_input, "no"); });
  EXPECT_THROW(field.value(Vec3d(0)), Error);
  EXPECT_THROW(field.value(Vec3d(0)), Error);
}

}  // namespace
}  // namespace vug::field
