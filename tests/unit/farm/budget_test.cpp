// SPDX-License-Identifier: Apache-2.0
// Time and money of a shot: closed forms for simple jobs.
#include <vug/farm/budget.h>

#include <gtest/gtest.h>

namespace vug::farm {
namespace {

JobOptions shot(int frames, int parts) {
  JobOptions out;
  out.scene = "/scenes/cave.vug";
  for (int i = 0; i < frames; ++i) out.frames.push_back(i + 1);
  out.spp = 64;
  out.parts = parts;
  out.cost = {.voxels = 1e6,
              .triangles = 1e5,
              .samples = 64e6,
              .build_seconds = 100,
              .learn_seconds = 20,
              .render_seconds = 3000,
              .bytes = 2e9};
  return out;
}

BudgetOptions free_of_charge() {
  BudgetOptions out;
  out.cores = 4;
  out.prices = {0, 0, 0, 0};
  return out;
}

const Place& place(const Budget& budget, const std::string& name) {
  for (const Place& each : budget.places)
    if (each.name == name) return each;
  throw std::out_of_range(name);
}

TEST(Budget, OneMachineMakesSharedProductsOnce) {
  const Budget shared = budget(shot(10, 1), true, free_of_charge());
  EXPECT_DOUBLE_EQ(place(shared, "one machine").hours, (100 + 10 * 3020.0) / 3600);
  EXPECT_DOUBLE_EQ(place(shared, "one machine").core_hours, 4 * (100 + 10 * 3020.0) / 3600);
  const Budget own = budget(shot(10, 1), false, free_of_charge());
  EXPECT_DOUBLE_EQ(place(own, "one machine").hours, 10 * 3120.0 / 3600);
  EXPECT_DOUBLE_EQ(own.grid_bytes, 10 * shared.grid_bytes);
}

TEST(Budget, MachinesOfAFarmShareFrames) {
  BudgetOptions options = free_of_charge();
  options.machines = 5;
  EXPECT_DOUBLE_EQ(place(budget(shot(10, 1), true, options), "farm").hours, 2 * 3120.0 / 3600);
  options.machines = 100;
  EXPECT_DOUBLE_EQ(place(budget(shot(10, 1), true, options), "farm").hours, 3120.0 / 3600)
      << "more machines than frames do not help";
}

TEST(Budget, PartsWaitForTheTaskThatLearns) {
  BudgetOptions options = free_of_charge();
  options.machines = 8;
  const Budget parted = budget(shot(1, 8), true, options);
  EXPECT_EQ(parted.tasks, 9u);
  EXPECT_DOUBLE_EQ(place(parted, "farm").hours, (120 + 100 + 3000.0 / 8) / 3600);
  EXPECT_DOUBLE_EQ(place(parted, "farm").core_hours, 4 * (120 + 8 * 100 + 3000.0) / 3600)
      << "each part makes the products again";
}

TEST(Budget, LostNodesCostAStartAndThePreparation) {
  BudgetOptions options = free_of_charge();
  options.machines = 1;
  options.spot = {.losses_per_hour = 0, .start_seconds = 0};
  const Budget safe = budget(shot(1, 1), true, options);
  EXPECT_DOUBLE_EQ(place(safe, "spot nodes").hours, place(safe, "farm").hours);
  options.spot = {.losses_per_hour = 0.5, .start_seconds = 30};
  const Budget lossy = budget(shot(1, 1), true, options);
  EXPECT_DOUBLE_EQ(place(lossy, "spot nodes").hours,
                   (3120 + 30 + 0.5 / 3600 * 3120 * (30 + 100)) / 3600);
}

TEST(Budget, MoneyIsCoreHoursStorageAndTransfer) {
  BudgetOptions options = free_of_charge();
  options.prices.core_hour = 2;
  const Budget hours = budget(shot(3, 1), false, options);
  for (const char* name : {"one machine", "farm"})
    EXPECT_DOUBLE_EQ(place(hours, name).money, 2 * place(hours, name).core_hours) << name;
  EXPECT_DOUBLE_EQ(place(hours, "spot nodes").money, 0);
  options.prices = {0, 0, 10, 0};
  options.months = 3;
  const Budget stored = budget(shot(3, 1), false, options);
  EXPECT_DOUBLE_EQ(place(stored, "farm").money,
                   30e-9 * (stored.grid_bytes + stored.mesh_bytes + stored.picture_bytes));
  options.prices = {0, 0, 0, 10};
  EXPECT_DOUBLE_EQ(place(budget(shot(3, 1), false, options), "farm").money,
                   10e-9 * stored.picture_bytes);
}

}  // namespace
}  // namespace vug::farm
