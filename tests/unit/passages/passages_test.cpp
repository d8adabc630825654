// SPDX-License-Identifier: Apache-2.0
// The passages of networks: volumes, walls, joints, rules, and the same bytes for any number of
// threads.
#include "passage_samples.h"

#include <vug/base/parallel.h>
#include <vug/volume/polygons.h>
#include <vug/volume/voxelize.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using field::Field;

volume::LevelSet level_set(const Field& field, double voxel) {
  volume::VoxelizeOptions options;
  options.voxel = voxel;
  return volume::voxelize(field, options);
}

/// By the fraction of random points inside, for fields without a voxelization.
double volume_inside(const Field& field, int count) {
  const Box3d& box = field.bounds();
  RandomStream random(RandomKey(9));
  int inside = 0;
  for (int i = 0; i < count; ++i)
    inside += field.value(box.center() + 0.5 * box.size() * random_vector(random, 1)) < 0;
  return box.size().x * box.size().y * box.size().z * inside / count;
}

PassageOptions plain() {
  PassageOptions options;
  options.rules = {};
  options.chamber = 1;
  return options;
}

// A quarter turn has a closed form (Pappus): area times length. The caps at both ends add about the
// area times the depth, 2 % of the whole.
TEST(Passages, TheVolumeIsTheIntegralOfTheArea) {
  std::vector<Vec3d> stations;
  std::vector<std::pair<int, int>> legs;
  for (int i = 0; i <= 8; ++i) {
    const double angle = 0.5 * kPi * i / 8;
    stations.push_back({40 * std::cos(angle), 0, 40 * std::sin(angle)});
    if (i > 0) legs.push_back({i - 1, i});
  }
  const auto network = with_radius(network_of(stations, legs), 1.5);
  const double length = 0.5 * kPi * 40;
  for (const SectionKind* kind : sections()) {
    PassageOptions options = plain();
    options.section = make_family(kind->info.name);
    const SectionPtr section = options.section->fit({3, 3, 0});
    const Field field = passages(network, options);
    const double caps = section->traits().area * section->traits().depth;
    EXPECT_NEAR(volume_inside(field, 400000), section->traits().area * length + caps,
                0.03 * section->traits().area * length)
        << kind->info.name;
  }
}

TEST(Passages, TheSurveyLineNeedNotBeInTheMiddle) {
  auto network = network_of({{0, 0, 0}, {0, 0, -20}}, {{0, 1}});  // Looking along -z, right is +x.
  for (auto& station : network.stations) station.section = network::CrossSection{1, 3, 4, 0.5};
  const Field field = passages(network, plain());
  for (const Vec3d& wall :
       {Vec3d(-1, 1.75, -10), Vec3d(3, 1.75, -10), Vec3d(1, 4, -10), Vec3d(1, -0.5, -10)})
    EXPECT_NEAR(field.value(wall), 0, 1e-9) << wall;
}

// Around a T of equal tubes: the walls opposite to the side passage and the roof stay where they
// are within 2 % (no bulge), and the side passage is nowhere narrower (no pinch).
TEST(Passages, JunctionsNeitherPinchNorBulge) {
  const double r = 2;
  for (const double angle : {0.5 * kPi, kPi / 3, 2 * kPi / 3}) {
    const Vec3d side(std::cos(angle), 0, std::sin(angle));
    const auto network = with_radius(
        network_of({{-20, 0, 0}, {0, 0, 0}, {20, 0, 0}, 20.0 * side}, {{0, 1}, {1, 2}, {1, 3}}), r);
    const Field field = passages(network, plain());
    for (double x = -8; x <= 8; x += 0.25) {
      EXPECT_NEAR(field.value({x, 0, -r}), 0, 0.02 * r) << angle << ": wall at " << x;
      EXPECT_NEAR(field.value({x, r, 0}), 0, 0.02 * r) << angle << ": roof at " << x;
      const double along = std::fabs(x);
      for (const double v : {-0.98 * r, 0.98 * r})
        EXPECT_LT(field.value(side * along + Vec3d(0, v, 0)), 0) << angle << ": pinch at " << along;
    }
  }
}

// Three equal legs at 120 degrees.
TEST(Passages, AStarOfEqualLegsHasNoPinch) {
  const double r = 2;
  std::vector<Vec3d> stations{{0, 0, 0}};
  for (int i = 0; i < 3; ++i)
    stations.push_back(Vec3d(std::cos(2 * kPi * i / 3), 0, std::sin(2 * kPi * i / 3)) * 20.0);
  PassageOptions options = plain();
  options.smooth = false;
  const Field field =
      passages(with_radius(network_of(stations, {{0, 1}, {0, 2}, {0, 3}}), r), options);
  for (int i = 1; i <= 3; ++i) {
    const Vec3d way = stations[static_cast<size_t>(i)].normalized(), aside(-way.z, 0, way.x);
    for (double s = 0; s < 15; s += 0.2)
      for (const Vec3d& v : {Vec3d(0, 0.98 * r, 0), aside * (0.98 * r), aside * (-0.98 * r)})
        EXPECT_LT(field.value(way * s + v), 0) << i << " at " << s;
  }
}

TEST(Passages, NearPassagesThatDoNotMeetStayApart) {
  // Two tubes with 5 cm of rock between them.
  const auto network = with_radius(
      network_of({{0, 0, 0}, {20, 0, 0}, {0, 0, 2.05}, {20, 0, 2.05}}, {{0, 1}, {2, 3}}), 1);
  EXPECT_NEAR(passages(network, plain()).value({10, 0, 1.025}), 0.025, 1e-9);
}

TEST(Passages, ChambersFormWherePassagesMeet) {
  const auto network =
      network_of({{-20, 0, 0}, {0, 0, 0}, {20, 0, 0}, {0, 0, 20}}, {{0, 1}, {1, 2}, {1, 3}});
  PassageOptions options = plain();
  options.size = {2, 2, 0.3};
  options.chamber = 1.5;
  const Field field = passages(network, options);
  EXPECT_NEAR(field.value({0, 1.5, 0}), 0, 0.05);
  EXPECT_NEAR(field.value({0, 0, -1.5}), 0, 0.05);
  EXPECT_NEAR(field.value({-15, 1, 0}), 0, 0.1);
}

TEST(Passages, RulesSelectTheSectionByStageSizeAndBed) {
  const auto roof = [](network::Stage stage, double radius) {
    auto network = with_radius(network_of({{0, 0, 0}, {20, 0, 0}}, {{0, 1}}), radius);
    network.legs[0].stage = stage;
    PassageOptions options;
    options.rules = {
        {.family = make_family("mined", {{"arch", Value(0.0)}}), .stage = network::Stage::vadose},
        {.family = make_family("mined", {{"arch", Value(0.0)}}), .min_width = 8},
        {.family = make_family("lens"), .bed = Bed{{0, 2, 0}, {0, 1, 0}, 1}}};
    return passages(network, options).value({10, 0.95 * radius, 0.95 * radius});
  };
  EXPECT_LT(roof(network::Stage::vadose, 1), 0);    // The corner of a rectangle is inside,
  EXPECT_GT(roof(network::Stage::phreatic, 1), 0);  // that of a circle outside.
  EXPECT_LT(roof(network::Stage::phreatic, 5), 0);
}

TEST(Passages, TheLevelSetHasTheSameBytesForAnyNumberOfThreads) {
  const auto network = random_cave(7, 80);
  const auto hash = [&](int threads) {
    return with_threads(threads, [&] {
      const auto polygons = volume::polygons_of(level_set(passages(network), 0.25));
      return std::make_pair(polygons.points, polygons.quads);
    });
  };
  const auto one = hash(1);
  EXPECT_EQ(one, hash(2));
  EXPECT_EQ(one, hash(7));
}

}  // namespace
}  // namespace vug::passages
