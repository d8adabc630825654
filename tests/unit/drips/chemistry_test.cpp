// SPDX-License-Identifier: Apache-2.0
// Rates of dripstone against tabulated values (dreybrodt1980, kaufmann2003), and drops against
// Tate's law.
#include <vug/base/vec.h>
#include <vug/drips/chemistry.h>
#include <vug/drips/drop.h>
#include <vug/drips/growth.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::drips {
namespace {

void expect_close(double value, double expected, double relative = 1e-3) {
  EXPECT_NEAR(value, expected, relative * expected);
}

TEST(Chemistry, HasThePublishedRates) {
  const double rates[][2] = {{5, 8.207e-8}, {10, 1.335e-7}, {15, 2.058e-7}, {20, 2.990e-7}};
  for (const auto& [temperature, rate] : rates) expect_close(deposition_rate(temperature), rate);
}

TEST(Chemistry, HasTheTabulatedConcentrations) {
  expect_close(equilibrium_calcium(5), 0.811, 1e-12);
  expect_close(equilibrium_calcium(20), 0.630, 1e-12);
  expect_close(seep_calcium(10, 0), 3.079, 1e-12);
  expect_close(seep_calcium(10, 1), 1.423, 1e-12);
  expect_close(seep_calcium(15), 0.5 * (2.824 + 1.232), 1e-12);
  for (double t = 0; t < 30; t += 0.5) EXPECT_GT(seep_calcium(t), seep_calcium(t + 0.5));
}

TEST(Chemistry, GrowsAndWidensAsTabulated) {
  struct Row {
    double temperature, interval, growth, radius;  // mm/yr, mm
  };
  // With drops of 0.1 cm3 and equal parts of open and closed dissolution.
  for (const Row& row :
       {Row{10, 10, .2337, 154.9}, Row{10, 30, .2306, 90.0}, Row{10, 100, .2203, 50.5},
        Row{10, 300, .1939, 31.1}, Row{10, 1000, .1299, 20.8}, Row{10, 1e4, .0176, 17.8},
        Row{20, 10, .4150, 103.9}, Row{20, 100, .3641, 35.1}, Row{20, 1000, .1338, 18.3}}) {
    const double growth = growth_rate(seep_calcium(row.temperature), row.temperature, row.interval);
    // Tables have three or four digits.
    EXPECT_NEAR(1e3 * growth, row.growth, 1e-3 * row.growth + 5e-5) << row.interval;
    EXPECT_NEAR(1e3 * trunk_radius(1e-7, row.temperature, row.interval), row.radius,
                1e-3 * row.radius + 0.05)
        << row.interval;
  }
}

TEST(Chemistry, TheTopOfATrunkTakesWhatADropBrings) {
  const double t = 12, interval = 75, volume = 7.6e-8, calcium = 2.1;
  const double radius = trunk_radius(volume, t, interval);
  const double laid =
      kPi * radius * radius * growth_rate(calcium, t, interval) * interval / kSecondsPerYear;
  expect_close(laid, kCalciteVolume * volume * (calcium - equilibrium_calcium(t)), 1e-9);
}

TEST(Chemistry, FilmsApproachEquilibrium) {
  EXPECT_DOUBLE_EQ(calcium_after(2, 10, 0, 1e-9), 2);
  // One exchange: discharge = alpha * area.
  const double area = 1e-9 / deposition_rate(10);
  expect_close(calcium_after(2, 10, area, 1e-9) - equilibrium_calcium(10),
               (2 - equilibrium_calcium(10)) / std::exp(1.0), 1e-12);
  expect_close(calcium_after(2, 10, 1e6, 1e-9), equilibrium_calcium(10), 1e-12);
}

TEST(Drop, HasTheSizesOfStrawsAndTheirDrops) {
  expect_close(surface_tension(20), 0.07274, 2e-3);
  expect_close(straw_diameter(10), 5.15e-3);
  EXPECT_GT(drop_volume(10, straw_diameter(10)), 70e-9);
  EXPECT_LT(drop_volume(10, straw_diameter(10)), 85e-9);
}

TEST(Drop, ScattersFromHighRoofs) {
  EXPECT_EQ(scatter_radius(1.9), 0);
  EXPECT_DOUBLE_EQ(scatter_radius(20), 0.05);
  EXPECT_DOUBLE_EQ(scatter_radius(11), 0.025);
}

TEST(Drop, FormsAtTheWavelengthOfAFilm) {
  const double degrees[][2] = {{0, 24.4}, {30, 26.3}, {45, 29.1}, {60, 34.6}, {75, 48.0}};
  for (const auto& [slope, wavelength] : degrees)
    EXPECT_NEAR(1e3 * drip_spacing(10, std::cos(slope * kPi / 180)), wavelength, 0.1) << slope;
}

TEST(Growth, StalactitesConsistOfWhatTheDropsLost) {
  const field::StalactiteCurve curve = common_curve(0.05);
  EXPECT_NEAR(root_radius(curve, 1, 0.00257), 0.05, 2e-4);
  for (const double interval : {5.0, 60.0, 900.0, 1e5}) {
    const Water water{7.6e-8 / interval, seep_calcium(10), 10, 8000};
    const StalactiteGrowth growth = grow_stalactite(water, interval, curve);
    EXPECT_GT(growth.length, 0);
    const double radius = root_radius(curve, growth.length, 0.00257);
    const double moles = kPi * radius * radius * growth.length / 2.5 / kCalciteVolume;
    const double lost =
        (water.calcium - growth.calcium) * water.discharge * water.age * kSecondsPerYear;
    EXPECT_NEAR(moles, lost, 0.06 * lost) << interval;
    EXPECT_GE(growth.calcium, equilibrium_calcium(10));
  }
}

}  // namespace
}  // namespace vug::drips
