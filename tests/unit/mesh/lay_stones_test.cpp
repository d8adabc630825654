// SPDX-License-Identifier: Apache-2.0
// Gravel: the distribution of sizes, the cover of the ground, sorting by the current.
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/stones/lay_stones.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::mesh {
namespace {

LayOptions gravel_options() {
  LayOptions o;
  o.sizes = {0.05, 0.4, 0.15, 1.4};
  o.cover = 0.1;
  o.key = RandomKey(4);
  o.choose_shape = [](RandomKey) { return size_t{0}; };
  return o;
}

const Mesh& floor_of_100_square_metres() {
  static const Mesh floor = box_mesh(Box3d(Vec3d(-5, -1, -5), Vec3d(5, 0, 5)));
  return floor;
}

const std::vector<StoneShape>& ball_shape() {
  static const std::vector<StoneShape> shapes = {stone_shape(sphere_mesh(Vec3d(0.0), 1, 2))};
  return shapes;
}

double diameter(const LaidStone& stone, const StoneShape& shape) {
  return stone.stone.rest.pose.scale * shape.diameter;
}

TEST(StoneSizes, TheMassFollowsRosinAndRammler) {
  const StoneSizes sizes{0.01, 1, 0.1, 1.3};
  const std::vector<StoneClass> classes = stone_classes(sizes);
  const double limit = classes[classes.size() / 2].largest;
  EXPECT_NEAR(limit, 0.1, 0.01);
  // The mass of a class is its cover times the diameter.
  double all = 0, below = 0, cover = 0;
  for (const StoneClass& one : classes) {
    all += one.cover * one.mean_diameter();
    cover += one.cover;
    if (one.largest < limit + 1e-9) below += one.cover * one.mean_diameter();
  }
  EXPECT_NEAR(cover, 1, 1e-12);
  const auto mass = [](double d) { return 1 - std::exp(-std::pow(d / 0.1, 1.3)); };
  EXPECT_NEAR(below / all, (mass(limit) - mass(0.01)) / (mass(1) - mass(0.01)), 1e-9);
  for (size_t i = 1; i < classes.size(); ++i)
    EXPECT_NEAR(classes[i].largest, classes[i - 1].smallest, 1e-12);
}

TEST(StoneSizes, SortingKeepsTheCover) {
  const std::vector<StoneClass> classes = stone_classes({0.02, 0.3, 0.1, 1.4});
  double last = 0;
  for (const double coarse : {0.0, 0.3, 0.7, 1.0}) {
    const std::vector<double> factors = sorting(classes, coarse, 0.2);
    double cover = 0, mean = 0;
    for (size_t i = 0; i < classes.size(); ++i) {
      cover += classes[i].cover * factors[i];
      mean += classes[i].cover * factors[i] * classes[i].mean_diameter();
    }
    EXPECT_NEAR(cover, 1, 1e-12);
    EXPECT_GT(mean, last);
    last = mean;
  }
}

TEST(StoneSizes, RefusesSizesOutOfOrder) {
  EXPECT_THROW(stone_classes({0.3, 0.2, 0.1, 1}), Error);
  EXPECT_THROW(stone_classes({0.2, 0.3, 1e-4, 5}), Error);
}

TEST(LayStones, CoversTheFractionOfTheGround) {
  const std::vector<LaidStone> laid =
      lay_stones(floor_of_100_square_metres(), ball_shape(), gravel_options());
  double area = 0;
  for (const LaidStone& stone : laid) {
    const double d = diameter(stone, ball_shape()[0]);
    EXPECT_GE(d, 0.05 - 1e-9);
    EXPECT_LE(d, 0.4 + 1e-9);
    area += 0.25 * kPi * d * d;
    // Balls on a floor, or on others, sunk in by a twentieth.
    EXPECT_GT(stone.stone.rest.pose.centre.y, 0.4 * d);
  }
  // Some fall on larger stones, which do not carry them.
  EXPECT_GT(area, 8);
  EXPECT_LT(area, 10.5);
}

TEST(LayStones, TheMaskAndTheCoarsenessSelectPlacesAndSizes) {
  LayOptions o = gravel_options();
  o.keep_probability = [](const SurfaceSample& spot) { return spot.position.z < 2 ? 1.0 : 0.0; };
  o.coarse = [](const SurfaceSample& spot) { return 1 - std::fabs(spot.position.x) / 5; };
  double middle = 0, edge = 0;
  int in_middle = 0, at_edge = 0;
  for (const LaidStone& stone : lay_stones(floor_of_100_square_metres(), ball_shape(), o)) {
    const Vec3d& p = stone.stone.rest.pose.centre;
    EXPECT_LT(p.z, 2.1);
    (std::fabs(p.x) < 1.5 ? middle : edge) += diameter(stone, ball_shape()[0]);
    ++(std::fabs(p.x) < 1.5 ? in_middle : at_edge);
  }
  EXPECT_GT(middle / in_middle, 1.6 * edge / at_edge);
}

TEST(LayStones, IsTheSameForAnyNumberOfThreads) {
  const auto with = [&](int threads) {
    return with_threads(threads, [] {
      return lay_stones(floor_of_100_square_metres(), ball_shape(), gravel_options());
    });
  };
  const std::vector<LaidStone> one = with(1);
  for (const int threads : {2, 7}) {
    const std::vector<LaidStone> other = with(threads);
    ASSERT_EQ(one.size(), other.size());
    for (size_t i = 0; i < one.size(); ++i)
      ASSERT_EQ(one[i].stone.rest.pose.centre, other[i].stone.rest.pose.centre);
  }
}

TEST(LayStones, RefusesTooMany) {
  LayOptions o = gravel_options();
  o.max_count = 50;
  EXPECT_THROW(lay_stones(floor_of_100_square_metres(), ball_shape(), o), Error);
  o.max_count = 1u << 30;
  o.sizes = {1e-5, 2e-5, 1e-5, 1};
  EXPECT_THROW(lay_stones(floor_of_100_square_metres(), ball_shape(), o), Error);
}

}  // namespace
}  // namespace vug::mesh
