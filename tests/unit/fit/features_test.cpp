// SPDX-License-Identifier: Apache-2.0
// Features, random forests and clusters on synthetic pictures.
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/fit/evidence/clusters.h>
#include <vug/fit/learning/random_forest.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace vug::fit {
namespace {

image::Image board(int width, int height) {
  image::Image out(width, height, {"R", "G", "B"});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (size_t c = 0; c < 3; ++c)
        out.at(x, y, c) = (x / 5 + y / 5) % 2 == 0 ? 0.8f : (c == 0 ? 0.5f : 0.1f);
  return out;
}

TEST(Features, LabOfKnownColours) {
  image::Image rgb(3, 1, {"R", "G", "B"});
  for (size_t c = 0; c < 3; ++c) rgb.at(0, 0, c) = 1;
  rgb.at(1, 0, 0) = 1;
  const Planes lab = to_lab(rgb);
  const double expected[3][3] = {{100, 0, 0}, {53.24, 80.09, 67.20}, {0, 0, 0}};
  for (size_t pixel = 0; pixel < 3; ++pixel)
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(lab.planes[c][pixel], expected[pixel][c], 0.05);
}

TEST(Features, AreFiniteAndComplete) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 1}, {40, 330}}) {
    const Planes planes = features(board(width, height));
    EXPECT_EQ(planes.count(), features(board(9, 9)).count());
    const Planes context = context_features({width, height, {planes.planes[0]}});
    for (const Planes* all : {&planes, &context})
      for (const auto& plane : all->planes) {
        ASSERT_EQ(plane.size(), static_cast<size_t>(width * height));
        for (const float v : plane) ASSERT_TRUE(std::isfinite(v));
      }
  }
}

TEST(Features, HighPassRemovesSlopes) {
  Planes slope{60, 100, {std::vector<float>(6000)}};
  for (size_t i = 0; i < 6000; ++i) slope.planes[0][i] = static_cast<float>(i / 60);
  const Planes flat = high_pass(slope);
  for (size_t y = 20; y < 80; ++y) EXPECT_NEAR(flat.planes[0][y * 60 + 30], 0, 1e-3);
}

/// Points whose class is the exclusive or of two signs, which no single threshold separates.
Examples exclusive(size_t count) {
  Examples out;
  out.features = 3;
  RandomStream stream{RandomKey(5)};
  for (size_t i = 0; i < count; ++i) {
    const double x = stream.uniform(-1, 1), y = stream.uniform(-1, 1);
    for (const double v : {x, y, stream.uniform()}) out.values.push_back(static_cast<float>(v));
    out.classes.push_back((x > 0) != (y > 0) ? 1 : 0);
  }
  return out;
}

Planes grid_of_points() {
  Planes out{20, 20, std::vector<std::vector<float>>(3)};
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {
      out.planes[0].push_back(static_cast<float>(x) / 10 - 0.95f);
      out.planes[1].push_back(static_cast<float>(y) / 10 - 0.95f);
      out.planes[2].push_back(0.5f);
    }
  return out;
}

TEST(Forest, LearnsExclusiveOr) {
  const Forest forest = Forest::train(exclusive(4000), 2, {}, RandomKey(1));
  const Planes points = grid_of_points(), found = forest.classify(points);
  int right = 0;
  for (size_t i = 0; i < points.pixels(); ++i) {
    EXPECT_NEAR(found.planes[0][i] + found.planes[1][i], 1, 1e-4);
    EXPECT_GT(found.planes[0][i], 0);
    const bool odd = (points.planes[0][i] > 0) != (points.planes[1][i] > 0);
    right += (found.planes[1][i] > 0.5f) == odd ? 1 : 0;
  }
  EXPECT_GT(right, 380);
  // Writing and reading preserve the model.
  const Planes again =
      Forest::from_json(nlohmann::json::parse(forest.to_json().dump())).classify(points);
  EXPECT_EQ(again.planes, found.planes);
}

TEST(Forest, ResultDoesNotDependOnThreads) {
  std::string first;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      const std::string text =
          Forest::train(exclusive(500), 2, {.trees = 5}, RandomKey(1)).to_json().dump();
      if (threads == 1) first = text;
      EXPECT_EQ(text, first);
    });
  }
}

TEST(Forest, InvalidInputIsRejected) {
  EXPECT_THROW(Forest::train({}, 2, {}, RandomKey(1)), Error);
  EXPECT_THROW(Forest::train(exclusive(10), 1, {}, RandomKey(1)), Error);
  const Forest forest = Forest::train(exclusive(300), 2, {.trees = 1}, RandomKey(1));
  EXPECT_THROW(forest.classify({1, 1, {{0.5f}}}), Error);
  for (const char* text : {"{}", "[]", "{\"classes\": 2, \"features\": 3, \"trees\": []}"})
    EXPECT_THROW(Forest::from_json(nlohmann::json::parse(text)), Error) << text;
  // Damaged in each of its parts.
  const nlohmann::json whole = forest.to_json();
  const auto broken = [&](const char* part, const auto& change) {
    nlohmann::json text = whole;
    change(text["trees"][0][part]);
    EXPECT_THROW(Forest::from_json(text), Error) << part;
  };
  broken("features", [](auto& list) { list[0] = 3; });
  broken("features", [](auto& list) { list[0] = -1; });
  broken("features", [](auto& list) { list.push_back(-1); });
  broken("features", [](auto& list) { list.erase(list.size() - 1); });
  broken("features", [](auto& list) { list.clear(); });
  broken("thresholds", [](auto& list) { list.push_back(0.5); });
  broken("thresholds", [](auto& list) { list.erase(list.size() - 1); });
  broken("votes", [](auto& list) { list[0] = 0; });
  broken("votes", [](auto& list) { list[0] = 251; });
  broken("votes", [](auto& list) { list.push_back(1); });
  broken("votes", [](auto& list) { list = "many"; });
}

TEST(Clusters, FindTheColoursOfACheckerboard) {
  const Planes lab = to_lab(board(50, 40));
  const std::vector<uint8_t> found = cluster(lab, {.clusters = 2}, RandomKey(1));
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 50; ++x)
      ASSERT_EQ(found[static_cast<size_t>(y * 50 + x)], (x / 5 + y / 5) % 2 == 0 ? 1 : 0)
          << "the darkest is the first";
}

TEST(Clusters, HolesInTheDepthFormTheirOwnCluster) {
  Planes planes{4, 1, {{50, 50, 50, 50}, {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 1, 1.01f, 0}}};
  planes.planes[3][3] = std::numeric_limits<float>::quiet_NaN();
  const std::vector<uint8_t> found = cluster(planes, {.clusters = 2}, RandomKey(1));
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
  EXPECT_NE(found[0], found[3]);
}

TEST(Clusters, FewColoursAndWrongCounts) {
  const Planes plain{5, 5, std::vector<std::vector<float>>(3, std::vector<float>(25, 7))};
  EXPECT_EQ(cluster(plain, {.clusters = 4}, RandomKey(1)), std::vector<uint8_t>(25, 0));
  EXPECT_THROW(cluster(plain, {.clusters = 0}, RandomKey(1)), Error);
  EXPECT_THROW(cluster(plain, {.clusters = 9}, RandomKey(1)), Error);
  EXPECT_THROW(cluster({0, 0, {}}, {}, RandomKey(1)), Error);
}

TEST(Clusters, ResultDoesNotDependOnThreads) {
  const Planes lab = to_lab(board(133, 97));
  std::vector<uint8_t> first;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      const std::vector<uint8_t> found = cluster(lab, {.clusters = 5}, RandomKey(3));
      if (threads == 1) first = found;
      EXPECT_EQ(found, first);
    });
  }
}

}  // namespace
}  // namespace vug::fit
