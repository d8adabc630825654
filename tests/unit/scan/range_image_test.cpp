// SPDX-License-Identifier: Apache-2.0
#include "clouds.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/scratch_folder.h>
#include <vug/scan/range_image.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace vug::scan {
namespace {

/// The plane z = 0 with x to the right and y up.
PlaneFit level_plane() { return {}; }

RangeImage image_of(std::vector<Vec3d> points, const RangeOptions& options) {
  PointCloud cloud;
  cloud.positions = std::move(points);
  return range_image(cloud, level_plane(), options);
}

TEST(RangeImage, TakesTheMedianOrTheNearest) {
  const std::vector<Vec3d> points = {{0, 0, 0.01}, {0.1, 0.1, 0.05}, {0.2, 0.1, -0.3},
                                     {0.95, 0, 0}, {0.3, 0.3, 0.9},  {0, 1.95, 0.02}};
  const RangeImage median = image_of(points, {.pixel = 0.5, .inpaint_radius = 0});
  ASSERT_EQ(median.width, 2);
  ASSERT_EQ(median.height, 4);
  EXPECT_EQ(median.depth[median.index(0, 3)], 0.01F);
  // The point 0.9 m in front of the plane is ignored.
  EXPECT_EQ(median.count[median.index(0, 3)], 3);
  EXPECT_EQ(median.depth[median.index(1, 3)], 0.0F);
  EXPECT_EQ(median.depth[median.index(0, 0)], 0.02F);
  EXPECT_TRUE(std::isnan(median.depth[median.index(1, 1)]));
  const RangeImage nearest = image_of(
      points, {.pixel = 0.5, .depth = DepthStatistic::nearest, .before = 2, .inpaint_radius = 0});
  EXPECT_EQ(nearest.depth[nearest.index(0, 3)], 0.9F);
}

TEST(RangeImage, LiesInItsFrame) {
  const RangeImage image =
      image_of({{3.2, 4.1, 0}, {4.35, 5.45, 0.05}}, {.pixel = 0.1, .inpaint_radius = 0});
  EXPECT_EQ(image.frame.origin, Vec3d(3.2, 4.1, 0));
  EXPECT_EQ(image.width, 12);
  EXPECT_EQ(image.height, 14);
  EXPECT_EQ(image.depth[image.index(11, 0)], 0.05F);
  EXPECT_NEAR(image.pixel_center(0, 13).x, 0.05, 1e-12);
  EXPECT_NEAR(image.pixel_center(0, 13).y, 0.05, 1e-12);
}

TEST(RangeImage, IgnoresDisconnectedPoints) {
  std::vector<Vec3d> points = {{-500, 0, 0}, {80, 1, 0}, {1e200, 3, 0}};
  for (int i = 0; i < 50; ++i) points.emplace_back(0.1 * i, 0.05 * i, 0);
  const RangeImage image = image_of(points, {.pixel = 0.1, .inpaint_radius = 0});
  EXPECT_EQ(image.width, 50);
  EXPECT_EQ(image.frame.origin, Vec3d(0, 0, 0));
}

TEST(RangeImage, OfOnePointIsOnePixel) {
  const RangeImage image = image_of({{3, 4, 0.02}}, {});
  EXPECT_EQ(image.width * image.height, 1);
  EXPECT_EQ(image.depth[0], 0.02F);
  EXPECT_EQ(image_of({{3, 4, 0}, {3, 4, 0}, {3, 4, 0}}, {}).count[0], 3);
}

/// Brute force reference of inpaint().
TEST(RangeImage, InpaintsFromTheNearestPixel) {
  RandomStream stream{RandomKey(5)};
  std::vector<Vec3d> points = {{0, 0, 0}, {0.395, 0.295, 0}};
  for (int i = 0; i < 60; ++i)
    points.emplace_back(stream.uniform(0, 0.4), stream.uniform(0, 0.3), stream.uniform(-0.1, 0.1));
  const RangeImage bare = image_of(points, {.pixel = 0.01, .inpaint_radius = 0});
  const RangeImage filled = image_of(points, {.pixel = 0.01, .inpaint_radius = 0.0301});
  size_t holes = 0;
  for (int y = 0; y < bare.height; ++y)
    for (int x = 0; x < bare.width; ++x) {
      int nearest = 10;  // Over squared distances up to 3 * 3.
      bool right = false;
      for (int v = 0; v < bare.height; ++v)
        for (int u = 0; u < bare.width; ++u) {
          const int square = (u - x) * (u - x) + (v - y) * (v - y);
          if (std::isnan(bare.depth[bare.index(u, v)]) || square > nearest) continue;
          right = (right && square == nearest) ||
                  bare.depth[bare.index(u, v)] == filled.depth[filled.index(x, y)];
          nearest = square;
        }
      holes += nearest == 10;
      EXPECT_EQ(std::isnan(filled.depth[filled.index(x, y)]), nearest == 10) << x << ' ' << y;
      EXPECT_TRUE(right || nearest == 10) << x << ' ' << y;
    }
  EXPECT_GT(holes, 10U);
  EXPECT_EQ(bare.count, filled.count);
}

TEST(RangeImage, HolesRemainAndSparseWallsAreInpainted) {
  const SyntheticFacade made{.step = 0.08, .noise = 0.002, .holes = {{2, 2, 2, 3, 0}}};
  const PointCloud cloud = made.cloud();
  PlaneFit plane;
  plane.frame = made.frame();
  EXPECT_NEAR(spacing(cloud, plane.frame), 0.08, 0.02);
  const RangeImage image = range_image(cloud, plane, {.pixel = 0.02});
  size_t holes = 0;
  for (const float d : image.depth) holes += std::isnan(d);
  EXPECT_NEAR(static_cast<double>(holes) * 0.02 * 0.02, 6, 1.1);
  const RangeImage bare = range_image(cloud, plane, {.pixel = 0.02, .inpaint_radius = 0});
  size_t points = 0;
  for (const uint16_t n : bare.count) points += n;
  EXPECT_EQ(points, cloud.size());
}

TEST(RangeImage, DoesNotDependOnThreads) {
  const PointCloud cloud = SyntheticFacade{.outliers = 0.2, .holes = {{2, 2, 2, 3, 0.1}}}.cloud();
  std::vector<RangeImage> images;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      images.push_back(range_image(cloud, fit_plane(cloud, {}, RandomKey(1)), {.pixel = 0.03}));
    });
  }
  for (const RangeImage& other : images) {
    EXPECT_EQ(other.count, images[0].count);
    EXPECT_EQ(
        std::memcmp(other.depth.data(), images[0].depth.data(), other.depth.size() * sizeof(float)),
        0);
  }
}

TEST(RangeImage, MemoryIsCheckedInAdvance) {
  const auto code_of = [](const RangeOptions& options) {
    try {
      image_of({{0, 0, 0}, {0.5, 0.5, 0}, {0.9, 0.9, 0}, {1.8, 1.8, 0}}, options);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::internal;
  };
  EXPECT_EQ(code_of({.pixel = 1e-3, .memory = 1 << 20}), ErrorCode::too_large);
  EXPECT_EQ(code_of({.pixel = 1e-9}), ErrorCode::too_large);
  EXPECT_EQ(code_of({.pixel = 1e-300}), ErrorCode::too_large);
  for (const double pixel : {0.0, -1.0, std::nan(""), kInfinity})
    EXPECT_EQ(code_of({.pixel = pixel}), ErrorCode::bad_input);
  EXPECT_EQ(code_of({.before = -1}), ErrorCode::bad_input);
  EXPECT_EQ(code_of({.inpaint_radius = std::nan("")}), ErrorCode::bad_input);
  EXPECT_THROW(image_of({{0, 0, 7}}, {}), Error);  // No points near the plane.
}

TEST(RangeImage, FileRoundTrip) {
  const PointCloud cloud = SyntheticFacade{.step = 0.2}.cloud();
  const RangeImage image = range_image(cloud, fit_plane(cloud, {}, RandomKey(1)), {.pixel = 0.07});
  const ScratchFolder scratch("vug_range");
  const std::string path = scratch.file("range.exr").string();
  write_range(path, image);
  const RangeImage back = read_range(path);
  EXPECT_EQ(back.width, image.width);
  EXPECT_EQ(back.pixel, image.pixel);
  EXPECT_EQ(back.frame.origin, image.frame.origin);
  EXPECT_EQ(back.frame.z, image.frame.z);
  EXPECT_EQ(back.count, image.count);
  EXPECT_EQ(read_range(path, 0.5).pixel, 0.5);
  EXPECT_THROW(read_range("no/such.exr"), Error);
}

}  // namespace
}  // namespace vug::scan
