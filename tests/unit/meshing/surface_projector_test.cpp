// SPDX-License-Identifier: Apache-2.0
// Batched evaluation and projection of points, compared with single evaluations in double
// precision.
#include "solids.h"

#include <vug/base/rng.h>
#include <vug/meshing/project.h>

#include <gtest/gtest.h>

namespace vug::meshing {
namespace {

constexpr double kVoxel = 0.05;
constexpr double kError = kLargestError * kVoxel;

std::vector<Vec3d> near_sphere(const Vec3d& centre, size_t count) {
  RandomStream random{RandomKey(5)};
  std::vector<Vec3d> points;
  while (points.size() < count) {
    const double x = random.normal();
    const double y = random.normal();
    const Vec3d side = Vec3d(x, y, random.normal()).normalized();
    points.push_back(centre + side * random.uniform(0.9, 1.1));
  }
  return points;
}

field::Field sphere_at(const Vec3d& centre) {
  return turned(field::make("sphere", {{"radius", 1.0}}), {0, 1, 0}, 0.3, centre);
}

TEST(SurfaceProjector, ProjectsOntoASphereAlongItsRadii) {
  for (const size_t count : {size_t{1}, size_t{7}, size_t{8}, size_t{300}}) {
    const field::Field ball = sphere_at(Vec3d(0));
    const std::vector<Vec3d> starts = near_sphere(Vec3d(0), count);
    SurfaceProjector projector(ball, starts, kError);
    EXPECT_FALSE(projector.in_double());
    const auto found = projector.project(starts, {0.2, 1e-4 * kVoxel, 10});
    ASSERT_EQ(found.size(), count);
    for (size_t i = 0; i < count; ++i) {
      const Vec3d exact = starts[i].normalized();
      EXPECT_LT((found[i].point - exact).length(), kError);
      EXPECT_LT((found[i].normal - exact).length(), 1e-5);
    }
  }
}

TEST(SurfaceProjector, StaysWithinTheReach) {
  const field::Field ball = sphere_at(Vec3d(0));
  const std::vector<Vec3d> starts = {{1.5, 0, 0}, {0, 1.02, 0}};
  const auto found = SurfaceProjector(ball, starts, kError).project(starts, {0.1, 0, 10});
  EXPECT_LE((found[0].point - starts[0]).length(), 0.1 + 1e-12);
  EXPECT_NEAR(found[1].point.y, 1, kError);
}

TEST(SurfaceProjector, UsesDoublesWhereSinglesAreTooCoarse) {
  const Vec3d centre(3e4, -2e4, 1e4);
  const field::Field ball = sphere_at(centre);
  const std::vector<Vec3d> starts = near_sphere(centre, 100);
  SurfaceProjector projector(ball, starts, kError);
  EXPECT_TRUE(projector.in_double());
  for (const SurfacePoint& s : projector.project(starts, {0.2, 1e-4 * kVoxel, 10}))
    EXPECT_NEAR((s.point - centre).length(), 1, 1e-4 * kVoxel);
}

TEST(SurfaceProjector, DecidesByValuesNotCoordinates) {
  // The centre of this sphere is far away; its surface passes through the origin.
  const field::Field globe =
      turned(field::make("sphere", {{"radius", 2e5}}), {0, 1, 0}, 0, {0, -2e5, 0});
  const std::vector<Vec3d> starts = {{0.3, 0.02, 0.1}, {-0.2, -0.03, 0.4}};
  SurfaceProjector projector(globe, starts, kError);
  EXPECT_TRUE(projector.in_double());
  for (const SurfacePoint& s : projector.project(starts, {0.2, 1e-4 * kVoxel, 10}))
    EXPECT_LT(std::fabs(globe.value(s.point)), 1e-4 * kVoxel);
}

TEST(SurfaceProjector, SamplesTheFieldAtEachPoint) {
  const field::Field solid = cut_box();
  const std::vector<Vec3d> points = near_sphere(Vec3d(0.1), 77);
  const auto found = SurfaceProjector(solid, points, kError).sample(points);
  for (size_t i = 0; i < points.size(); ++i) {
    const field::Gradient g = solid.gradient(points[i]);
    EXPECT_EQ(found[i].point, points[i]);
    EXPECT_NEAR(found[i].residual, std::fabs(g.value), kError);
    EXPECT_LT((found[i].normal - g.gradient).length(), 1e-5);
  }
}

}  // namespace
}  // namespace vug::meshing
