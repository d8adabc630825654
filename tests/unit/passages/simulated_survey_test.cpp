// SPDX-License-Identifier: Apache-2.0
// Surveys of fields: distances in closed form, and the round trip from passages over a file to
// passages.
#include "passage_samples.h"
#include "surface_topology.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/scratch_folder.h>
#include <vug/field/boolean.h>
#include <vug/karst/generate.h>
#include <vug/karst/presets.h>
#include <vug/network/from_survey.h>
#include <vug/network/section_statistics.h>
#include <vug/passages/distance_to_wall.h>
#include <vug/passages/simulated_survey.h>
#include <vug/survey_files/read_survey.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace vug::passages {
namespace {

/// A straight passage to the east with the line 0.5 m left of and 0.25 m below its axis.
network::Network straight_line() {
  network::Network network = network_of({{0, 0, 0}, {12, 0, 0}, {30, 0, 0}}, {{0, 1}, {1, 2}});
  for (network::Station& station : network.stations)
    station.section = network::CrossSection{1.0, 2.0, 1.25, 0.75};
  return network;
}

/// The height of an ellipse of half-axes a and b at u from its centre.
double ellipse_height(double a, double b, double u) { return b * std::sqrt(1 - u * u / (a * a)); }

TEST(SimulatedSurvey, DistancesOfAnEllipticTubeAreExact) {
  PassageOptions tube;
  tube.rules.clear();
  const field::Field air = passages(straight_line(), tube);
  const SimulatedSurvey simulated = simulate_survey(air, straight_line(), {.longest_leg = 6});
  EXPECT_EQ(simulated.in_rock, 0);
  ASSERT_EQ(simulated.survey.tubes.size(), 1u);
  const survey::Tube& sections = simulated.survey.tubes[0];
  ASSERT_EQ(sections.size(), 6u);  // 12 m in two legs, 18 m in three.
  const double across = ellipse_height(1, 1.5, 0.25), along = ellipse_height(1.5, 1, 0.5);
  for (size_t i = 1; i + 1 < sections.size(); ++i) {  // The ends are round.
    EXPECT_NEAR(*sections[i].left, across - 0.5, 1e-4) << i;
    EXPECT_NEAR(*sections[i].right, across + 0.5, 1e-4) << i;
    EXPECT_NEAR(*sections[i].up, along + 0.25, 1e-4) << i;
    EXPECT_NEAR(*sections[i].down, along - 0.25, 1e-4) << i;
  }
  double length = 0;
  int splays = 0;
  for (const survey::Leg& leg : simulated.survey.legs) {
    if (leg.splay)
      ++splays;
    else
      length += leg.length;
  }
  EXPECT_NEAR(length, 30, 1e-9);
  EXPECT_GE(splays, 24 * 4);
}

TEST(SimulatedSurvey, RockAndAirHaveTheSameSurvey) {
  const field::Field air = passages(straight_line());
  const field::Field rock = field::complement(air);
  const SimulatedSurvey a = simulate_survey(air, straight_line()),
                        b = simulate_survey(rock, straight_line());
  ASSERT_EQ(a.survey.stations.size(), b.survey.stations.size());
  for (size_t i = 0; i < a.survey.stations.size(); ++i)
    EXPECT_LT((a.survey.stations[i].position - b.survey.stations[i].position).length(), 1e-5);
}

TEST(SimulatedSurvey, StationsInRockHaveNoWallsAndFarWallsAreNotMeasured) {
  network::Network line = straight_line();
  const field::Field air = passages(line);
  line.stations.push_back({.name = "rock", .position = {30, 20, 0}});
  line.legs.push_back({.from = 2, .to = 3});
  const SimulatedSurvey simulated = simulate_survey(air, line, {.longest_leg = 100, .reach = 1.0});
  EXPECT_EQ(simulated.in_rock, 1);
  ASSERT_EQ(simulated.survey.tubes.size(), 1u);
  EXPECT_TRUE(simulated.survey.tubes[0][1].left.has_value());
  EXPECT_FALSE(simulated.survey.tubes[0][1].right.has_value());
}

/// Passages along three sides of a square; the line of the network cuts its corners.
TEST(SimulatedSurvey, LegsKeepLinesOfSight) {
  const std::vector<Vec3d> corners{{0, 0, 0}, {12, 0, 0}, {12, 0, 12}, {0, 0, 12}};
  PassageOptions straight;
  straight.smooth = false;
  const field::Field air =
      passages(with_radius(network_of(corners, {{0, 1}, {1, 2}, {2, 3}}), 1), straight);
  const network::Network line = network_of({{0.5, 0, 0}, {10, 0, 0.8}, {11.4, 0, 11}, {2, 0, 13.5}},
                                           {{0, 1}, {1, 2}, {2, 3}});
  const survey::Survey survey = simulate_survey(air, line, {.longest_leg = 20}).survey;
  EXPECT_GT(survey.tubes[0].size(), 4u);
  for (const survey::Leg& leg : survey.legs) {
    if (leg.splay) continue;
    const auto scene = [&](int station) {
      const Vec3d& p = survey.stations[static_cast<size_t>(station)].position;
      return Vec3d(p.x, p.z, -p.y);
    };
    const Vec3d from = scene(leg.from), to = scene(leg.to);
    // Legs are not shorter than 0.1 m, so some graze an edge.
    for (double t = 0; t <= 1; t += 0.01) EXPECT_LT(air.value(from + (to - from) * t), 0.02) << t;
  }
}

TEST(SimulatedSurvey, RefusesBadOptionsAndNetworksWithoutLegs) {
  const network::Network line = straight_line();
  const field::Field air = passages(line);
  EXPECT_THROW(simulate_survey(air, network::Network{}), Error);
  EXPECT_THROW(simulate_survey(air, line, {.longest_leg = 0}), Error);
  EXPECT_THROW(simulate_survey(air, line, {.longest_leg = 1e-9}), Error);
  EXPECT_THROW(simulate_survey(air, line, {.splays = -1}), Error);
  EXPECT_THROW(simulate_survey(air, line, {.tilt = std::nan("")}), Error);
  EXPECT_THROW(simulate_survey(air, line, {.reach = INFINITY}), Error);
}

TEST(DistanceToWall, IsTheDistanceAlongTheRayFromBothSides) {
  const field::Field air = passages(with_radius(network_of({{0, 0, 0}, {40, 0, 0}}, {{0, 1}}), 2));
  const Vec3d slanted = Vec3d(3, 4, 0).normalized();
  EXPECT_NEAR(*distance_to_wall(air, {20, 0, 0}, slanted, 50), 2 / slanted.y, 1e-4);
  EXPECT_NEAR(*distance_to_wall(air, {20, 10, 0}, {0, -1, 0}, 50), 8, 1e-4);
  EXPECT_FALSE(distance_to_wall(air, {20, 10, 0}, {0, 1, 0}, 50).has_value());
  EXPECT_FALSE(distance_to_wall(air, {20, 0, 0}, {1, 0, 0}, 15).has_value());
}

/// A small cave of the generator, without measured sizes.
network::Network generated_cave(uint64_t seed) {
  karst::Preset small = karst::find_preset("branchwork");
  small.geology.bounds = {{-60, -16, -60}, {60, 14, 60}};
  small.options.seed = seed;
  small.options.samples.count = 1500;
  small.options.growth.sinks = 3;
  small.options.growth.dead_ends = 6;
  return karst::generate(small.geology, small.options);
}

/// The same with sizes that vary by a third around those of real caves.
network::Network cave_of_many_sizes(uint64_t seed) {
  network::SectionModel sizes;
  sizes.width_spread = sizes.height_spread = 0.3;
  return network::draw_sections(generated_cave(seed), sizes, seed);
}

/// Whether the surface is within `distance` of a point: found along the gradient.
bool is_near_surface(const field::Field& field, const Vec3d& p, double distance) {
  const Vec3d gradient = field.gradient(p).gradient;
  if (!(gradient.length() > 0)) return false;
  const Vec3d out = gradient.normalized();
  return distance_to_wall(field, p, field.value(p) < 0 ? out : out * -1.0, distance).has_value();
}

struct RoundTrip {
  size_t splays = 0, near = 0, samples = 0, inside = 0;
  size_t inside_before = 0;  ///< Samples of the line inside the passages that were surveyed.
  size_t inside_both = 0;
  field::Field passages;  ///< From the splays.
};

RoundTrip round_trip(const network::Network& cave) {
  const ScratchFolder scratch("vug_simulated_survey");
  const std::filesystem::path file = scratch.file("simulated_survey.3d");
  const field::Field before = passages(cave);
  survey::write_survey(simulate_survey(before, cave).survey, file);
  Diagnostics warnings;
  const network::Network read =
      network::from_survey(survey::read_survey(file, {}, warnings), {.place = {.recenter = false}});
  const field::Field again = passages(read);
  RoundTrip out;
  for (const network::Station& station : read.stations)
    for (const Vec3d& splay : station.splays) {
      ++out.splays;
      out.near += is_near_surface(again, splay, 0.3);
    }
  for (const network::Leg& leg : read.legs)
    for (double t = 0.05; t < 1; t += 0.1) {
      ++out.samples;
      const Vec3d p = read.stations[static_cast<size_t>(leg.from)].position +
                      network::leg_vector(read, leg) * t;
      const bool inside = again.value(p) < 0, was_inside = before.value(p) < 0;
      out.inside += inside;
      out.inside_before += was_inside;
      out.inside_both += inside && was_inside;
    }
  out.passages = again;
  return out;
}

double fraction(size_t part, size_t of) {
  return static_cast<double>(part) / static_cast<double>(of);
}

void print(const char* label, const RoundTrip& r) {
  std::printf(
      "%s: %.2f %% of %zu splays within 0.3 m; %.2f %% of the line inside, %.2f %% before, "
      "of which %.2f %% stay\n",
      label, 100 * fraction(r.near, r.splays), r.splays, 100 * fraction(r.inside, r.samples),
      100 * fraction(r.inside_before, r.samples), 100 * fraction(r.inside_both, r.inside_before));
}

void expect_same_passages(const RoundTrip& result) {
  EXPECT_GT(result.splays, 500u);
  EXPECT_GE(fraction(result.near, result.splays), 0.9);
  EXPECT_GE(fraction(result.inside, result.samples), 0.95);
}

void expect_solid(const field::Field& passages) {
  const mesh::Topology topology = topology_of(passages, 0.25);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.misoriented_edges, 0u);
  EXPECT_EQ(topology.nonmanifold_vertices, 0u);
}

TEST(SimulatedSurveyRoundTrip, PassagesFromSplaysAreThoseThatWereSurveyed) {
  const RoundTrip result = round_trip(generated_cave(2));
  print("equal sizes", result);
  expect_same_passages(result);
  expect_solid(result.passages);
}

TEST(SimulatedSurveyRoundTrip, SizesThatVaryAreThoseThatWereSurveyed) {
  for (const uint64_t seed : {2U, 3U, 4U, 5U, 6U}) {
    SCOPED_TRACE(seed);
    const RoundTrip result = round_trip(cave_of_many_sizes(seed));
    print("many sizes", result);
    expect_same_passages(result);
  }
}

TEST(SimulatedSurveyRoundTrip, BytesDoNotDependOnTheNumberOfThreads) {
  const network::Network cave = generated_cave(3);
  const field::Field air = passages(cave);
  const survey::Format& format = survey::writable_format_of("cave.lox");
  const std::string one =
      with_threads(1, [&] { return format.write(simulate_survey(air, cave).survey); });
  for (const int threads : {2, 7})
    EXPECT_EQ(one, with_threads(threads,
                                [&] { return format.write(simulate_survey(air, cave).survey); }));
}

}  // namespace
}  // namespace vug::passages
