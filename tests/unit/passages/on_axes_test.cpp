// SPDX-License-Identifier: Apache-2.0
// Points on the axes of passages lie in their air.
#include "passage_samples.h"

#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/karst/generate.h>
#include <vug/karst/presets.h>
#include <vug/network/along.h>
#include <vug/network/reduction.h>
#include <vug/network/section_statistics.h>
#include <vug/passages/on_axes.h>

#include <cmath>

namespace vug::passages {
namespace {

/// A cave of a preset on fewer samples, with the sections of surveyed caves.
network::Network generated(const karst::Preset& preset) {
  karst::KarstOptions options = preset.options;
  options.samples.count = 1500;
  return network::draw_sections(karst::generate(preset.geology, options), {}, 1);
}

size_t in_rock(const field::Field& air, const std::vector<Vec3d>& points) {
  return static_cast<size_t>(std::count_if(points.begin(), points.end(),
                                           [&](const Vec3d& p) { return !(air.value(p) < 0); }));
}

std::vector<Vec3d> positions(const network::Network& network, size_t count) {
  std::vector<Vec3d> points;
  for (size_t i = 0; i < count; ++i) points.push_back(network.stations[i].position);
  return points;
}

void expect_in_air(const network::Network& cave, const PassageOptions& options) {
  const field::Field air = passages(cave, options);
  const network::Network middle = on_axes(cave, options);
  ASSERT_GE(middle.stations.size(), cave.stations.size());
  EXPECT_EQ(in_rock(air, positions(middle, cave.stations.size())), 0U);
  const std::vector<Vec3d> points = network::points_along(middle, 5);
  EXPECT_GT(points.size(), 300U);
  EXPECT_EQ(in_rock(air, points), 0U);
}

TEST(OnAxes, StationsAndPointsBetweenThemAreInTheAir) {
  for (const karst::Preset& preset : karst::presets()) {
    SCOPED_TRACE(preset.name);
    const network::Network cave = generated(preset);
    expect_in_air(cave, {});
    PassageOptions options;
    options.smooth = false;
    expect_in_air(cave, options);
    options.smooth = true;
    options.meanders.sinuosity = 1.4;
    expect_in_air(cave, options);
  }
}

TEST(OnAxes, TheMiddleOfEachFamilyIsAir) {
  const network::Network cave = generated(karst::find_preset("branchwork"));
  for (const SectionKind* kind : sections()) {
    SCOPED_TRACE(kind->info.name);
    PassageOptions options;
    options.rules.clear();
    options.section = make_family(kind->info.name);
    expect_in_air(cave, options);
  }
}

TEST(OnAxes, IsTheNetworkItselfWhereWallsAreEven) {
  const network::Network cave = with_radius(
      network_of({{0, 0, 0}, {10, 0, 0}, {20, 2, 0}, {10, 0, 9}}, {{0, 1}, {1, 2}, {1, 3}}), 1);
  PassageOptions options;
  options.smooth = false;
  const network::Network middle = on_axes(cave, options);
  ASSERT_EQ(middle.stations.size(), 4U);
  for (size_t i = 0; i < 4; ++i)
    EXPECT_LT((middle.stations[i].position - cave.stations[i].position).length(), 1e-12);
  EXPECT_EQ(network::cave_graph(middle).graph.edges, network::cave_graph(cave).graph.edges);
}

TEST(OnAxes, KeepsTheGraphAndTheStations) {
  const network::Network cave = generated(karst::find_preset("maze_anastomotic"));
  const network::Network middle = on_axes(cave);
  for (size_t i = 0; i < cave.stations.size(); ++i)
    EXPECT_EQ(middle.stations[i].name, cave.stations[i].name);
  const network::Reduction before = network::reduce(cave), after = network::reduce(middle);
  EXPECT_EQ(before.nodes, after.nodes);
  EXPECT_EQ(before.branches.size(), after.branches.size());
}

TEST(OnAxes, EquatedStationsStayTogetherAndLegsWithoutPassagesAreOmitted) {
  network::Network cave =
      network_of({{0, 0, 0}, {5, 0, 0}, {5, 0, 0}, {9, 0, 3}}, {{0, 1}, {2, 3}, {0, 3}});
  cave.legs[2].surface = true;
  for (network::Station& station : cave.stations)
    station.section = network::CrossSection{0.2, 1.8, 1.0, 1.0};
  const network::Network middle = on_axes(cave);
  EXPECT_EQ(middle.stations[1].position, middle.stations[2].position);
  EXPECT_NE(middle.stations[1].position, cave.stations[1].position);
  for (const network::Leg& leg : middle.legs) EXPECT_FALSE(leg.surface);
  cave.stations[0].position.x = std::nan("");
  EXPECT_THROW(on_axes(cave), Error);
}

}  // namespace
}  // namespace vug::passages
