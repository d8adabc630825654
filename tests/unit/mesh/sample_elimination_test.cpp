// SPDX-License-Identifier: Apache-2.0
#include <vug/base/rng.h>
#include <vug/mesh/sample_elimination.h>

#include <gtest/gtest.h>

namespace vug::mesh {
namespace {

TEST(SampleElimination, EqualsSequentialElimination) {
  RandomStream random(RandomKey(1));
  std::vector<Vec3f> given;
  for (int i = 0; i < 4000; ++i) {
    const double x = random.uniform(), y = random.uniform();
    given.push_back(Vec3f(Vec3d(x, y, 0.1 * random.uniform())));
  }
  const double radius = 0.05;
  const PointGrid grid(given, radius);
  const auto count = static_cast<uint32_t>(grid.size());
  std::vector<uint64_t> rank(count);
  for (uint64_t& r : rank) r = random.below(10) == 0 ? 0 : 1 + random.below(100000);
  const auto close = [&](uint32_t i, uint32_t j) {
    return (grid.points()[i] - grid.points()[j]).length2() < static_cast<float>(radius * radius);
  };

  std::vector<uint32_t> turn(count);
  for (uint32_t i = 0; i < count; ++i) turn[i] = i;
  std::stable_sort(turn.begin(), turn.end(),
                   [&](uint32_t i, uint32_t j) { return rank[i] < rank[j]; });
  std::vector<uint8_t> expected(count, 0);
  for (const uint32_t i : turn) {
    bool free = true;
    for (uint32_t j = 0; j < count && rank[i] > 0; ++j) free &= !(expected[j] && close(i, j));
    expected[i] = free;
  }
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads,
                 [&] { EXPECT_EQ(eliminate_samples(grid, rank, close), expected) << threads; });
  }
}

}  // namespace
}  // namespace vug::mesh
