// SPDX-License-Identifier: Apache-2.0
#include "clouds.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::scan {
namespace {

constexpr double kDegree = kPi / 180;

PlaneFit fit(const PointCloud& cloud, const PlaneOptions& options = {}) {
  return fit_plane(cloud, options, RandomKey(7));
}

void expect_frame(const PlaneFrame& found, const PlaneFrame& made, double angle) {
  EXPECT_GT(found.x.dot(made.x), maths::cos(angle));
  EXPECT_GT(found.y.dot(made.y), maths::cos(angle));
  EXPECT_GT(found.z.dot(made.z), maths::cos(angle));
  EXPECT_NEAR((found.x.cross(found.y) - found.z).length(), 0, 1e-12);
  EXPECT_NEAR(made.local(found.origin).z, 0, 0.01);
}

TEST(Plane, IsFoundAmongStrayPoints) {
  SyntheticFacade made{.outliers = 0.5, .holes = {{2, 2, 2, 3, 0.15}, {6, 1, 2, 5, 0.15}}};
  for (const double yaw : {0.0, 0.7, 2.5, -1.2}) {
    made.yaw = yaw;
    const PlaneFit found = fit(made.cloud(), {.tolerance = 0.03});
    expect_frame(found.frame, made.frame(), 0.1 * kDegree);
    EXPECT_NEAR(found.rms, made.noise, 0.002);
    EXPECT_LT(found.lean, 0.1 * kDegree);
  }
}

TEST(Plane, IsExactFarFromTheOrigin) {
  SyntheticFacade made{.outliers = 0.2, .holes = {{2, 2, 2, 3, 0.2}}};
  made.corner = {32549123.457, 5804321.001, 54.3};
  const PlaneFit found = fit(made.cloud(), {.tolerance = 0.03});
  expect_frame(found.frame, made.frame(), 0.1 * kDegree);
}

TEST(Plane, FrontIsWhereTheScannerStood) {
  const SyntheticFacade made{.step = 0.1, .noise = 0.002};  // No information about the front.
  const PlaneFrame frame = made.frame();
  PointCloud cloud = made.cloud();
  for (const double side : {1.0, -1.0}) {
    PlaneOptions options;
    options.scanner = frame.world({5, 1, 9 * side});
    EXPECT_GT(fit(cloud, options).frame.z.dot(frame.z) * side, 0.999);
    options.flip = true;
    EXPECT_LT(fit(cloud, options).frame.z.dot(frame.z) * side, -0.999);
    cloud.normals.assign(cloud.size(), Vec3f(frame.z * side));
    cloud.normals[0] = Vec3f(std::nanf(""));
    EXPECT_GT(fit(cloud).frame.z.dot(frame.z) * side, 0.999);
  }
}

TEST(Plane, UprightPlanesArePreferredToTheGround) {
  PointCloud cloud = SyntheticFacade{.step = 0.1}.cloud();
  RandomStream stream{RandomKey(3)};
  for (int i = 0; i < 30000; ++i)  // Three times as many points as the facade.
    cloud.positions.emplace_back(stream.uniform(-20, 40), stream.uniform(-20, 40), 3);
  EXPECT_LT(fit(cloud).lean, 1 * kDegree);
  EXPECT_GT(fit(cloud, {.max_lean = kPi / 2}).lean, 89 * kDegree);
}

TEST(Plane, RespectsTheMaximumLean) {
  PointCloud cloud;
  RandomStream stream{RandomKey(3)};
  for (int i = 0; i < 5000; ++i) {
    const double x = stream.uniform(0, 10), z = stream.uniform(0, 5);
    cloud.positions.emplace_back(x, 0.02 * z, z);
  }
  EXPECT_NEAR(fit(cloud).lean, 0.02, 1e-4);
  EXPECT_NEAR(fit(cloud, {.max_lean = 0}).lean, 0, 1e-7);
}

TEST(Plane, DoesNotDependOnThreads) {
  const PointCloud cloud = SyntheticFacade{.outliers = 0.3, .holes = {{2, 2, 2, 3, 0.15}}}.cloud();
  std::vector<PlaneFit> fits;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] { fits.push_back(fit(cloud)); });
  }
  for (const PlaneFit& other : fits) {
    EXPECT_EQ(other.frame.origin, fits[0].frame.origin);
    EXPECT_EQ(other.frame.z, fits[0].frame.z);
    EXPECT_EQ(other.rms, fits[0].rms);
  }
}

TEST(Plane, UnusableCloudsAreRejected) {
  PointCloud line;
  EXPECT_THROW(fit(line), Error);
  line.positions.emplace_back(1, 2, 3);
  EXPECT_THROW(fit(line), Error);
  line.positions.assign(100, {1, 2, 3});  // The same point repeatedly.
  EXPECT_THROW(fit(line), Error);
  for (size_t i = 0; i < 100; ++i) line.positions[i] = Vec3d(1, 2, 3) * static_cast<double>(i);
  EXPECT_THROW(fit(line), Error);
  line.positions.emplace_back(0, 0, 1);
  EXPECT_NO_THROW(fit(line));
  EXPECT_THROW(fit(line, {.tolerance = 0}), Error);
  EXPECT_THROW(fit(line, {.tolerance = std::nan("")}), Error);
  EXPECT_THROW(fit(line, {.up = Vec3d(0)}), Error);
  EXPECT_THROW(fit(line, {.max_lean = -1}), Error);
  EXPECT_THROW(fit(line, {.confidence = 1}), Error);
}

}  // namespace
}  // namespace vug::scan
