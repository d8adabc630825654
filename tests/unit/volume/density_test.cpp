// SPDX-License-Identifier: Apache-2.0
// The data for ray traversal of fog: values, stochastic samples, and bounds.
#include "solids.h"

#include <vug/base/rng.h>
#include <vug/volume/density.h>
#include <vug/volume/fog.h>
#include <vug/volume/resampled.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::volume {
namespace {

/// Rough fog in a ball about 100 voxels across, so in several bricks of 64.
const Density& rough() {
  static const Density density = [] {
    VoxelizeOptions options;
    options.voxel = 0.02;
    return Density(resampled(fog(voxelize(sphere_at({0.3, 0, 0}, 1), options)), [](const Vec3f& p) {
      RandomKey key(3);
      for (int axis = 0; axis < 3; ++axis)
        key = key.at(static_cast<uint64_t>(std::lround(p[axis] * 50)));
      RandomStream random(key);
      return static_cast<float>(random.uniform());
    }));
  }();
  return density;
}

Vec3f place(RandomStream& random, const Vec3f& size) {
  Vec3f p;
  for (int axis = 0; axis < 3; ++axis)
    p[axis] = static_cast<float>(random.uniform(0, static_cast<double>(size[axis])));
  return p;
}

TEST(Density, TheMeanOfStochasticValuesIsTheInterpolatedOne) {
  const Density& density = rough();
  RandomStream random(RandomKey(1).at("places"));
  int rough_places = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3f p = place(random, density.size());
    double sum = 0, squares = 0;
    constexpr int kTrials = 20000;
    for (int k = 0; k < kTrials; ++k) {
      const auto value = static_cast<double>(density.stochastic_at(p, place(random, Vec3f(1.0f))));
      sum += value, squares += value * value;
    }
    const double mean = sum / kTrials;
    const double error = std::sqrt(std::max(squares / kTrials - mean * mean, 0.0) / kTrials);
    EXPECT_NEAR(mean, static_cast<double>(density.at(p)), 4.5 * error + 1e-6);
    rough_places += error > 1e-4;
  }
  EXPECT_GT(rough_places, 10);
  // At a lattice point there is only one choice, and beyond the grid the value is 0.
  const Vec3f lattice(40, 50, 60);
  EXPECT_GT(density.at(lattice), 0);
  EXPECT_EQ(density.stochastic_at(lattice, Vec3f(0.0f)), density.at(lattice));
  EXPECT_EQ(density.stochastic_at(density.size(), Vec3f(0.0f)), 0);
  EXPECT_EQ(density.stochastic_at(Vec3f(-0.5f), Vec3f(0.0f)), 0);
}

TEST(Density, BricksOfEverySizeBoundIt) {
  const Density& density = rough();
  std::vector<int> sizes;
  double bound = 0;
  for (const MajorantGrid& bricks : density.majorants()) {
    sizes.push_back(bricks.size());
    const auto side = static_cast<float>(bricks.size());
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(static_cast<float>(bricks.count()[axis]) * side, density.size()[axis]);
      EXPECT_LT(static_cast<float>(bricks.count()[axis] - 1) * side, density.size()[axis]);
    }
    RandomStream random(RandomKey(2).at("places"));
    double mean = 0, known = 0;
    constexpr int kTrials = 200000;
    for (int k = 0; k < kTrials; ++k) {
      const Vec3f p = place(random, density.size());
      const MajorantGrid::Range& range = bricks.range(bricks.index(Vec3i(p / side)));
      const float value = density.at(p);
      ASSERT_GE(value, range.min - 1e-6f);
      ASSERT_LE(value, range.max + 1e-6f);
      mean += static_cast<double>(value), known += static_cast<double>(range.mean);
    }
    EXPECT_NEAR(known, mean, 0.06 * mean) << bricks.size();
    EXPECT_GE(bricks.bound(), bound);  // Larger bricks have looser bounds.
    bound = bricks.bound();
  }
  EXPECT_EQ(sizes, (std::vector<int>{8, 16, 32, 64}));
}

TEST(Density, EmptyFogHasNoBricks) {
  const Grid where = fog(voxelize(sphere_at({0, 0, 0}, 1), {}));
  const Density none(resampled(where, [](const Vec3f&) { return 0.0f; }));
  EXPECT_EQ(none.at_world(Vec3f(0.0f)), 0);
  EXPECT_TRUE(none.bounds().isEmpty());
  for (const MajorantGrid& bricks : none.majorants()) EXPECT_EQ(bricks.bound(), 0);
}

}  // namespace
}  // namespace vug::volume
