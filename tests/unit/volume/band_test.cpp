// SPDX-License-Identifier: Apache-2.0
// Values that accompany a level set: at its voxels, and found again by position.
#include "solids.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/band.h>

#include <gtest/gtest.h>

namespace vug::volume {
namespace {

LevelSet ball(double voxel) {
  VoxelizeOptions options;
  options.voxel = voxel;
  return voxelize(sphere_at({0.2, 0, 0.1}, 1), options);
}

TEST(Band, PointsLieOnTheSurface) {
  const double voxel = 0.05;
  const BandPoints band = volume::band_points(ball(voxel));
  ASSERT_GT(band.size(), 10000u);
  double off = 0, turned = 0;
  for (size_t i = 0; i < band.size(); ++i) {
    const Vec3d out = Vec3d(band.foot[i]) - Vec3d(0.2, 0, 0.1);
    off = std::max(off, std::fabs(out.length() - 1));
    turned = std::max(turned, (out.normalized() - Vec3d(band.normal[i])).length());
  }
  // At the edge of the band differences are one-sided, half a voxel off: a rotation of half a voxel
  // over the radius there, and a foot displaced by the same angle three voxels away.
  EXPECT_LT(turned, 1.5 * voxel);
  EXPECT_LT(off, 3 * voxel * turned);
}

TEST(Band, GridsHoldTheirValuesWhereTheLevelSetIs) {
  const LevelSet solid = ball(0.05);
  const BandPoints band = volume::band_points(solid);
  std::vector<float> heights;
  for (const Vec3f& p : band.foot) heights.push_back(p.y);
  const Grid height = band_grid(solid, heights), colour = band_grid(solid, band.normal);
  EXPECT_EQ(height.value_type(), "float");
  EXPECT_EQ(colour.value_type(), "vec3s");
  EXPECT_EQ(height.voxel_size(), solid.voxel_size());
  for (const Grid& each : {height, colour}) {
    EXPECT_EQ(each.grid_class(), GridClass::fog);
    EXPECT_EQ(each.statistics().active_voxels, solid.statistics().active_voxels);
    EXPECT_EQ(each.statistics().index_min, solid.statistics().index_min);
  }
  const Digest expected = height.content();
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] { EXPECT_EQ(band_grid(solid, heights).content(), expected); });
  }
  heights.pop_back();
  EXPECT_THROW(band_grid(solid, heights), Error);
  const std::vector<int32_t> ones(band.size(), 1);
  const Grid numbers = band_grid(solid, ones);
  EXPECT_EQ(numbers.value_type(), "int32");
  EXPECT_EQ(numbers.grid_class(), GridClass::unknown);
}

TEST(Band, PositionsAreThoseOfTheVoxels) {
  const LevelSet solid = ball(0.05);
  const std::vector<Vec3f> positions = band_positions(solid);
  const BandPoints band = volume::band_points(solid);
  ASSERT_EQ(positions.size(), band.size());
  for (size_t i = 0; i < positions.size(); ++i) {
    const double value = solid.value(Vec3d(positions[i]));
    const Vec3f foot = positions[i] - band.normal[i] * static_cast<float>(value);
    EXPECT_LT((foot - band.foot[i]).length(), 1e-5f);
  }
}

}  // namespace
}  // namespace vug::volume
