// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/mesh/point_grid.h>

#include <gtest/gtest.h>

#include <set>

namespace vug::mesh {
namespace {

std::vector<Vec3f> cloud(size_t count, const Vec3d& size, uint64_t seed) {
  RandomStream random{RandomKey(seed)};
  std::vector<Vec3f> points;
  for (size_t i = 0; i < count; ++i) {
    const double x = random.uniform() * size.x, y = random.uniform() * size.y;
    const double z = random.uniform() * size.z;
    points.push_back(Vec3f(Vec3d(x, y, z) - size * 0.3));
  }
  return points;
}

using Pairs = std::set<std::pair<uint32_t, uint32_t>>;

/// Pairs of point numbers closer than the edge, as found by for_each_cube.
Pairs swept(const std::vector<Vec3f>& points, double edge) {
  const PointGrid grid(points, edge);
  std::vector<std::vector<uint32_t>> near(points.size());
  grid.for_each_cube([&](PointGrid::Run cube, const PointGrid::Runs& around) {
    for (uint32_t i = cube.begin; i < cube.end; ++i)
      for (const PointGrid::Run& run : around)
        for (uint32_t j = run.begin; j < run.end; ++j)
          if ((grid.points()[i] - grid.points()[j]).length() < static_cast<float>(edge))
            near[i].push_back(j);
  });
  Pairs pairs;
  for (size_t i = 0; i < near.size(); ++i)
    for (const uint32_t j : near[i])
      EXPECT_TRUE(pairs.emplace(grid.order()[i], grid.order()[j]).second) << "met twice";
  return pairs;
}

TEST(PointGrid, FindsEveryPairThatBruteForceFinds) {
  // A cube, a sheet, a line, one thinner than an edge, and all points at one position.
  for (const Vec3d& size :
       {Vec3d(1, 1, 1), Vec3d(0.01, 3, 2), Vec3d(0, 0, 8), Vec3d(0.1, 5, 0.05), Vec3d(0, 0, 0)}) {
    const double edge = 0.2;
    const std::vector<Vec3f> points = cloud(600, size, 7);
    Pairs expected;
    for (uint32_t i = 0; i < points.size(); ++i)
      for (uint32_t j = 0; j < points.size(); ++j)
        if ((points[i] - points[j]).length() < static_cast<float>(edge)) expected.emplace(i, j);
    EXPECT_EQ(swept(points, edge), expected) << size;
  }
  EXPECT_TRUE(swept({}, 1).empty());
}

TEST(PointGrid, OrderDependsOnPositionsNotIndices) {
  std::vector<Vec3f> points = cloud(5000, Vec3d(1, 2, 3), 3);
  const PointGrid before(points, 0.1);
  std::reverse(points.begin(), points.end());
  const PointGrid after(points, 0.1);
  EXPECT_EQ(before.points(), after.points());
  for (size_t i = 0; i < points.size(); ++i) ASSERT_EQ(after.points()[i], points[after.order()[i]]);
}

TEST(PointGrid, RefusesTooManyCubes) {
  EXPECT_THROW(PointGrid({Vec3f(0), Vec3f(1e6f, 0, 0)}, 0.01), Error);
}

}  // namespace
}  // namespace vug::mesh
