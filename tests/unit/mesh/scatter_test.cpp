// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/mesh/scatter.h>
#include <vug/mesh/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

ScatterOptions options(double spacing, uint64_t seed = 1) {
  ScatterOptions o;
  o.spacing = spacing;
  o.key = RandomKey(seed);
  return o;
}

TEST(Scatter, FillsAFloorDenselyWithoutCloseSamples) {
  const Mesh floor = box_mesh(Box3d(Vec3d(0, -1, 0), Vec3d(10, 0, 10)));
  const double spacing = 0.25;
  ScatterOptions o = options(spacing);
  o.keep_probability = [](const SurfaceSample& spot) { return spot.normal.y > 0.5 ? 1.0 : 0.0; };
  const std::vector<SurfaceSample> spots = scatter(floor, o);
  for (size_t i = 0; i < spots.size(); ++i) {
    ASSERT_NEAR(spots[i].position.y, 0, 1e-9);
    for (size_t j = 0; j < i; ++j)
      ASSERT_GE((spots[i].position - spots[j].position).length(), spacing);
  }
  // Discs of half the spacing, thrown at random until none fits, cover 0.547 of a plane.
  // Convergence is slow: it follows the inverse root of the number of tries.
  const double covered = static_cast<double>(spots.size()) * kPi * spacing * spacing / 4 / 100;
  EXPECT_GT(covered, 0.47);
  EXPECT_LT(covered, 0.547);
}

TEST(Scatter, IsUniformOverTrianglesOfAnySize) {
  // One half of small triangles, one half of two large ones.
  Mesh floor;
  for (int i = 0; i <= 32; ++i)
    for (int j = 0; j <= 32; ++j)
      floor.positions.push_back(
          {static_cast<float>(i) * 0.125f, 0, static_cast<float>(j) * 0.125f});
  for (uint32_t i = 0; i < 32; ++i)
    for (uint32_t j = 0; j < 32; ++j) {
      const uint32_t at = i * 33 + j;
      floor.triangles.push_back({at, at + 1, at + 34});
      floor.triangles.push_back({at, at + 34, at + 33});
    }
  const auto first = static_cast<uint32_t>(floor.positions.size());
  for (const Vec3f& p : {Vec3f(-4, 0, 0), Vec3f(-4, 0, 4), Vec3f(0, 0, 4), Vec3f(0, 0, 0)})
    floor.positions.push_back(p);
  floor.triangles.push_back({first, first + 1, first + 2});
  floor.triangles.push_back({first, first + 2, first + 3});
  const std::vector<SurfaceSample> spots = scatter(floor, options(0.1));
  const auto right = std::count_if(spots.begin(), spots.end(),
                                   [](const SurfaceSample& s) { return s.position.x > 0; });
  const auto all = static_cast<double>(spots.size());
  EXPECT_NEAR(static_cast<double>(right), all / 2, 5 * std::sqrt(all / 4));
}

TEST(Scatter, DensityFollowsTheProbabilityAndOthersStay) {
  const Mesh ball = sphere_mesh(Vec3d(0), 2, 4);
  const std::vector<SurfaceSample> all = scatter(ball, options(0.1));
  ScatterOptions o = options(0.1);
  o.keep_probability = [](const SurfaceSample&) { return 0.3; };
  const std::vector<SurfaceSample> some = scatter(ball, o);
  const auto n = static_cast<double>(all.size());
  EXPECT_NEAR(static_cast<double>(some.size()), 0.3 * n, 5 * std::sqrt(0.21 * n));
  size_t at = 0;
  for (const SurfaceSample& spot : some) {
    while (at < all.size() && all[at].key.state() != spot.key.state()) ++at;
    ASSERT_LT(at, all.size());
    EXPECT_EQ(all[at].position, spot.position);
  }
  ScatterOptions few = options(0.1);
  few.max_count = 10;
  EXPECT_EQ(scatter(ball, few).size(), 10u);
}

TEST(Scatter, IsTheSameForAnyNumberOfThreadsAndDiffersBySeed) {
  const Mesh ball = sphere_mesh(Vec3d(0), 2, 3);
  const auto positions = [&](int threads, uint64_t seed) {
    return with_threads(threads, [&] {
      ScatterOptions o = options(0.2, seed);
      o.keep_probability = [](const SurfaceSample& spot) { return 0.5 + 0.2 * spot.position.x; };
      std::vector<double> out;
      for (const SurfaceSample& spot : scatter(ball, o))
        out.insert(out.end(), {spot.position.x, spot.position.y, spot.position.z});
      return out;
    });
  };
  EXPECT_EQ(positions(1, 1), positions(7, 1));
  EXPECT_NE(positions(1, 1), positions(1, 2));
}

TEST(Scatter, RefusesTooManyCandidates) {
  const Mesh ball = sphere_mesh(Vec3d(0), 1000, 2);
  EXPECT_THROW(scatter(ball, options(0.001)), Error);
  EXPECT_TRUE(scatter(Mesh(), options(1)).empty());
}

}  // namespace
}  // namespace vug::mesh
