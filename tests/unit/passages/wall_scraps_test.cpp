// SPDX-License-Identifier: Apache-2.0
// Walls of passages as scraps: their components, their place in survey space, and .lox files.
#include "passage_samples.h"
#include "surface_topology.h"

#include <vug/base/error.h>
#include <vug/field/boolean.h>
#include <vug/passages/passages.h>
#include <vug/passages/simulated_survey.h>
#include <vug/passages/wall_scraps.h>
#include <vug/survey_files/format.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace vug::passages {
namespace {

/// A tube of radius 2 m to the east.
network::Network tube_from(const Vec3d& start) {
  network::Network out = with_radius(
      network_of({start, start + Vec3d(14, 0, 0), start + Vec3d(30, 0, 0)}, {{0, 1}, {1, 2}}), 2);
  out.origin = {400000, 5000000, 300};
  return out;
}

field::Field air_of(const network::Network& network) {
  PassageOptions options;
  options.rules.clear();
  return passages(network, options);
}

/// Rock with faces of its own around two tubes, of which one is surveyed.
mesh::Mesh surface_of_rock(const network::Network& surveyed) {
  const field::Field other = air_of(tube_from({0, 0, 20}));
  // The outer face is that of a wider tube around both.
  const field::Field rock =
      air_of(with_radius(network_of({{-15, 0, 10}, {45, 0, 10}}, {{0, 1}}), 18));
  return surface_of(field::subtract(rock, {air_of(surveyed), other}), 0.5);
}

double volume_of(const survey::Scrap& scrap) {
  double sum = 0;
  const Vec3d from = scrap.points.front();
  for (const std::array<int, 3>& t : scrap.triangles) {
    const auto corner = [&](size_t k) { return scrap.points[static_cast<size_t>(t[k])] - from; };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return sum;
}

TEST(WallScraps, AreTheComponentsAroundTheStations) {
  const network::Network network = tube_from({0, 0, 0});
  for (const int splays : {0, 12}) {
    const SimulatedSurvey simulated = simulate_survey(air_of(network), network, {.splays = splays});
    const mesh::Mesh surface = surface_of_rock(network);
    ASSERT_EQ(mesh::inspect(surface).components, 3u);
    const std::vector<survey::Scrap> scraps =
        wall_scraps(surface, simulated.survey, network.origin);
    ASSERT_EQ(scraps.size(), 1u);
    // The tube with half spheres at its ends, around which the rock is outside.
    EXPECT_NEAR(-volume_of(scraps[0]), kPi * 4 * 30 + kPi * 32 / 3, 15);
    for (const Vec3d& p : scraps[0].points) {
      const Vec3d at = p - network.origin;
      const double along = std::clamp(at.x, 0.0, 30.0);
      EXPECT_NEAR((at - Vec3d(along, 0, 0)).length(), 2, 0.1);
    }
  }
  EXPECT_THROW(wall_scraps({}, {}, Vec3d(0.0)), Error);
}

TEST(WallScraps, SurviveInLoxFiles) {
  const network::Network network = tube_from({0, 0, 0});
  SimulatedSurvey simulated = simulate_survey(air_of(network), network, {.splays = 4});
  simulated.survey.scraps =
      wall_scraps(surface_of(air_of(network), 0.5), simulated.survey, network.origin);
  const survey::Format& lox = survey::format_of("walls.lox");
  Diagnostics warnings;
  const auto again =
      std::get<survey::Survey>(lox.read(lox.write(simulated.survey), "walls.lox", {}, warnings));
  ASSERT_EQ(again.scraps.size(), 1u);
  EXPECT_EQ(again.scraps[0].points, simulated.survey.scraps[0].points);
  EXPECT_EQ(again.scraps[0].triangles, simulated.survey.scraps[0].triangles);
  EXPECT_TRUE(warnings.all().empty());
  // Each edge is used once in each direction: the walls are closed and oriented.
  std::map<std::pair<int, int>, int> edges;
  for (const std::array<int, 3>& t : again.scraps[0].triangles)
    for (size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, uses] : edges) {
    EXPECT_EQ(uses, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_GT(volume_of(again.scraps[0]), 0);
}

}  // namespace
}  // namespace vug::passages
