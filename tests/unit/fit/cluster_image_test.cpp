// SPDX-License-Identifier: Apache-2.0
// Downsampled pictures, and the cluster images that trees are fitted to.
#include "painted.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/scratch_folder.h>
#include <vug/fit/evidence/cluster_image.h>
#include <vug/fit/evidence/working_size.h>
#include <vug/image/io.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

namespace vug::fit {
namespace {

constexpr float kHole = std::numeric_limits<float>::quiet_NaN();

TEST(WorkingSize, KeepsProportionsAndSmallPictures) {
  EXPECT_EQ(working_size(378, 667), (WorkingSize{204, 360}));
  EXPECT_EQ(working_size(100, 50), (WorkingSize{100, 50}));
  EXPECT_EQ(working_size(1, 1), (WorkingSize{1, 1}));
  const WorkingSize wide = working_size(100'000, 1000);
  EXPECT_LE(wide.width * wide.height, 251'000);
  EXPECT_NEAR(static_cast<double>(wide.width) / wide.height, 100, 2);
  EXPECT_EQ(working_size(1, 100'000), (WorkingSize{1, 360}));
}

TEST(WorkingSize, MeansOverParts) {
  image::Image line(3, 1, {"Z"});
  line.pixels = {3, 6, 9};
  EXPECT_EQ(downsampled(line, {1, 1}).pixels, std::vector<float>{6});
  // Two halves of 1.5 pixels each.
  EXPECT_EQ(downsampled(line, {2, 1}).pixels, (std::vector<float>{4, 8}));
  line.pixels = {3, kHole, 9};
  EXPECT_EQ(downsampled(line, {2, 1}).pixels, (std::vector<float>{3, 9}));
  line.pixels = {3, kHole, kHole};
  EXPECT_TRUE(std::isnan(downsampled(line, {1, 1}).pixels[0])) << "mostly a hole";
  EXPECT_EQ(resampled({1, 2, 3}, {3, 1}, {1, 1}), std::vector<uint8_t>{2});
  EXPECT_EQ(resampled({1, 2}, {2, 1}, {4, 2}), (std::vector<uint8_t>{1, 1, 2, 2, 1, 1, 2, 2}));
  EXPECT_THROW(resampled({}, {0, 0}, {1, 1}), Error);
  EXPECT_THROW(downsampled(line, {4, 1}), Error);
  EXPECT_THROW(downsampled(line, {0, 1}), Error);
}

TEST(WorkingSize, MeansArePreserved) {
  const PaintedFacade facade = painted(1, 121, 163);
  const image::Image small = downsampled(facade.photo, {40, 50});
  const auto mean = [](const image::Image& of) {
    double sum = 0;
    for (const float v : of.pixels) sum += v;
    return sum / static_cast<double>(of.pixels.size());
  };
  EXPECT_NEAR(mean(small), mean(facade.photo), 1e-5);
}

TEST(WorkingSize, GreyPhotosAndTheMemoryLimit) {
  const ScratchFolder scratch("vug_grey_photo");
  const auto path = scratch.file("photo.png");
  image::Image grey(4, 3, {"Y"});
  for (float& v : grey.pixels) v = 0.25f;
  image::write_png(path, grey, image::plain_view());
  const image::Image read = read_photo(path);
  EXPECT_EQ(read.channels, (std::vector<std::string>{"R", "G", "B"}));
  for (const float v : read.pixels) EXPECT_NEAR(v, 0.25, 0.01);
  try {
    read_photo(path, 100);
    FAIL() << "the memory limit was not enforced";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
  }
}

std::vector<bool> is(const std::vector<uint8_t>& marks, uint8_t what) {
  std::vector<bool> out;
  for (const uint8_t mark : marks) out.push_back(mark == what);
  return out;
}

TEST(ClusterImage, FirstClusterIsGlassUnderAnyLighting) {
  for (const int number : {1, 2, 3}) {
    const PaintedFacade facade = painted(number);
    const ClusterImage found = cluster_image(&facade.photo, nullptr, {}, RandomKey(1));
    EXPECT_EQ(found.clusters, 2);
    // Without the rows of sky and shop, where contrast misleads it.
    std::vector<bool> glass = is(found.labels, 0), windows = is(facade.classes, kWindow);
    for (size_t i = 0; i < glass.size(); ++i)
      if (facade.classes[i] != kWindow && facade.classes[i] != kStone) glass[i] = false;
    EXPECT_GT(overlap(glass, windows), 0.7) << number;
  }
}

/// Windows 30 cm behind a wall, with 2 cm of noise.
image::Image depths_of(const PaintedFacade& facade, bool holes) {
  image::Image out(facade.width(), facade.height(), {"Z"});
  RandomStream stream(RandomKey(3));
  for (size_t i = 0; i < out.pixels.size(); ++i) {
    const bool window = facade.classes[i] == kWindow;
    out.pixels[i] = static_cast<float>(20 + (window ? 0.3 : 0) + 0.02 * stream.normal());
    if (holes && window && stream.below(2) == 0) out.pixels[i] = kHole;
  }
  return out;
}

TEST(ClusterImage, DepthDecidesAndHolesAreEvidence) {
  const PaintedFacade facade = painted(1);
  for (const bool holes : {false, true}) {
    const image::Image depth = depths_of(facade, holes);
    const ClusterImage found = cluster_image(&facade.photo, &depth, {}, RandomKey(1));
    EXPECT_EQ(found.clusters, holes ? 3 : 2) << "noise does not form clusters";
    std::vector<bool> deep;
    for (const uint8_t of : found.labels) deep.push_back(of <= (holes ? 1 : 0));
    EXPECT_GT(overlap(deep, is(facade.classes, kWindow)), 0.95);
  }
}

TEST(ClusterImage, PanesAndFramesShareOneDepthCluster) {
  constexpr int kSide = 30;
  image::Image depth(kSide, kSide, {"Z"});
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const int in = std::min({x - 8, 20 - x, y - 8, 20 - y});  // Pixels inside the window.
      depth.at(x, y) = in < 0 ? 20.0f : in < 3 ? 20.2f : 20.24f;
    }
  const ClusterImage found = cluster_image(nullptr, &depth, {.depth_clusters = 5}, RandomKey(1));
  EXPECT_EQ(found.clusters, 2);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      EXPECT_EQ(found.labels[static_cast<size_t>(y * kSide + x)],
                std::min({x - 8, 20 - x, y - 8, 20 - y}) < 0 ? 1 : 0);
}

TEST(ClusterImage, PhotoDecidesForFlatDepths) {
  const PaintedFacade facade = painted(1);
  image::Image depth(facade.width(), facade.height(), {"Z"});
  for (float& v : depth.pixels) v = 5;
  EXPECT_EQ(cluster_image(&facade.photo, &depth, {}, RandomKey(1)).labels,
            cluster_image(&facade.photo, nullptr, {}, RandomKey(1)).labels);
  EXPECT_EQ(cluster_image(nullptr, &depth, {}, RandomKey(1)).clusters, 1);
  for (float& v : depth.pixels) v = kHole;
  EXPECT_EQ(cluster_image(nullptr, &depth, {}, RandomKey(1)).clusters, 1) << "nothing but holes";
}

TEST(ClusterImage, PlainAndTinyAndBrokenPictures) {
  image::Image plain(9, 7, {"R", "G", "B"});
  EXPECT_EQ(cluster_image(&plain, nullptr, {}, RandomKey(1)).clusters, 1);
  plain.pixels[5] = kHole;
  EXPECT_EQ(cluster_image(&plain, nullptr, {}, RandomKey(1)).clusters, 1) << "NaN is black";
  const image::Image pixel(1, 1, {"R", "G", "B"});
  EXPECT_EQ(cluster_image(&pixel, nullptr, {}, RandomKey(1)).labels, std::vector<uint8_t>{0});
  const image::Image depth(2, 1, {"Z"});
  EXPECT_THROW(cluster_image(&pixel, &depth, {}, RandomKey(1)), Error);
  EXPECT_THROW(cluster_image(nullptr, nullptr, {}, RandomKey(1)), Error);
  EXPECT_THROW(cluster_image(nullptr, &pixel, {}, RandomKey(1)), Error);
  EXPECT_THROW(cluster_image(&pixel, nullptr, {.photo_clusters = 99}, RandomKey(1)), Error);
  EXPECT_THROW(cluster_image(nullptr, &depth, {.depth_clusters = 8}, RandomKey(1)), Error);
}

TEST(ClusterImage, ResultDoesNotDependOnThreads) {
  const PaintedFacade facade = painted(2);
  std::vector<uint8_t> first;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      const ClusterImage found = cluster_image(&facade.photo, nullptr, {}, RandomKey(3));
      if (threads == 1) first = found.labels;
      EXPECT_EQ(found.labels, first);
    });
  }
}

}  // namespace
}  // namespace vug::fit
