// SPDX-License-Identifier: Apache-2.0
// The figures of the SG+M paper (zawadzki2012) on smaller ranges; docs/explanation/theory/sgm.md
// has all of them.
#include "facts.h"

#include <vug/delivery/measure.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::session {
namespace {

metrics::Report measured(const std::vector<scene::Override>& overrides,
                         std::optional<uint64_t> seed = {}) {
  const loading::Loaded loaded = load_scene("figure9.vug", overrides, seed);
  building::Builder builder(loaded.shot);
  return delivery::measure(builder);
}

// Figure 11. Facets between surface points have a second-order error, so halving the voxel reduces
// the difference to the next value to about a quarter; details of voxel size reduce it only to
// half.
TEST(Figures, SurfaceAndVolumeConvergeWithLd) {
  std::vector<metrics::Report> at;
  for (const char* ld : {"3", "6", "12"}) at.push_back(measured({{"LD", ld}}));
  const double area_step = std::abs(at[1].area - at[0].area);
  const double volume_step = std::abs(at[1].volume - at[0].volume);
  EXPECT_LT(std::abs(at[2].area - at[1].area), 0.5 * area_step);
  EXPECT_LT(std::abs(at[2].volume - at[1].volume), 0.5 * volume_step);
  EXPECT_NEAR(at[2].area / at[1].area, 1, 0.02);
  EXPECT_NEAR(at[2].volume / at[1].volume, 1, 0.01);
  // Cells with all corners inside: a lower bound, one layer of cells less.
  EXPECT_LT(*at[0].volume_cells, *at[1].volume_cells);
  EXPECT_LT(*at[1].volume_cells, *at[2].volume_cells);
  EXPECT_LT(*at[2].volume_cells, at[2].volume);
  EXPECT_GT(*at[2].volume_cells, at[2].volume - at[2].area / 12);
}

// Figure 10. A surface has as many triangles as cell faces that it crosses: LD squared.
TEST(Figures, TrianglesGrowWithTheSquareOfLd) {
  const double coarse = static_cast<double>(measured({{"LD", "5"}}).triangles);
  const double fine = static_cast<double>(measured({{"LD", "10"}}).triangles);
  EXPECT_NEAR(fine / coarse, 4, 0.2);
}

// Figure 9, for some seeds: twelve productions, and a cave that extends further along +X than its
// initial shape and further than in any other direction.
TEST(Figures, CavesOfAnySeedHaveTwelveProductionsAndGrowAlongX) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    const metrics::Report cave = measured({{"LD", "4"}}, seed);
    const metrics::Report first = measured({{"LD", "4"}, {"PC", "1"}, {"PM", "0"}}, seed);
    EXPECT_EQ(cave.productions, 12U);
    EXPECT_EQ(first.productions, 1U);
    EXPECT_TRUE(cave.is_closed_solid());
    const double ahead = cave.bounds.max.x - first.bounds.max.x;
    EXPECT_GT(ahead, 0);
    EXPECT_GT(ahead, first.bounds.min.x - cave.bounds.min.x);
    for (const int axis : {1, 2}) {
      EXPECT_GT(ahead, cave.bounds.max[axis] - first.bounds.max[axis]);
      EXPECT_GT(ahead, first.bounds.min[axis] - cave.bounds.min[axis]);
    }
    ASSERT_TRUE(cave.cf && cave.cf_area);
    EXPECT_GT(*cave.cf, 50);  // seen from outside a cave is mostly convex, see the docs
    EXPECT_LT(*cave.cf, 100);
    EXPECT_NEAR(*cave.cf, *cave.cf_area, 6);
  }
}

}  // namespace
}  // namespace vug::session
