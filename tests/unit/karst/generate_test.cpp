// SPDX-License-Identifier: Apache-2.0
#include "caves.h"

#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/field/registry.h>
#include <vug/network/metrics.h>

#include <cmath>
#include <set>

namespace vug::karst {
namespace {

using network::Network;

TEST(Karst, IsTheSameForAnyNumberOfThreads) {
  for (const char* name : {"maze_rectilinear", "tiers", "spongework"}) {
    const Preset& preset = find_preset(name);
    std::vector<std::string> digests;
    for (const int threads : {1, 2, 7})
      digests.push_back(digest_of(with_threads(threads, [&] {
                          return generate(preset.geology, preset.options);
                        })).hex());
    EXPECT_EQ(digests[0], digests[1]) << name;
    EXPECT_EQ(digests[0], digests[2]) << name;
  }
}

TEST(Karst, SeedsGiveDifferentCaves) {
  const Geology geology = small_geology();
  EXPECT_NE(digest_of(generate(geology, small_options(1))),
            digest_of(generate(geology, small_options(2))));
}

TEST(Karst, IsOneConnectedNetworkWithUniqueNames) {
  for (const Preset& preset : presets()) {
    KarstOptions options = preset.options;
    options.samples.count = 1500;
    const Network cave = generate(preset.geology, options);
    ASSERT_NO_THROW(network::require_valid(cave));
    EXPECT_EQ(network::measure(cave).components, 1) << preset.name;
    std::set<std::string> names;
    for (const network::Station& station : cave.stations) {
      EXPECT_FALSE(station.name.empty());
      EXPECT_TRUE(names.insert(station.name).second) << station.name;
    }
    for (const network::Leg& leg : cave.legs) {
      EXPECT_TRUE(leg.survey.starts_with("passage."));
      EXPECT_NE(leg.stage, network::Stage::unknown);
    }
  }
}

TEST(Karst, KeyPointsKeepTheirPlaces) {
  Geology geology = small_geology();
  geology.entrances = {Vec3d(0, 30, 90)};
  geology.waypoints = {Vec3d(20, -10, -80)};
  geology.sinks[1].name = "Stream";
  const Network cave = generate(geology, small_options());
  const auto position = [&](const char* name) {
    const int station = station_named(cave, name);
    EXPECT_GE(station, 0) << name;
    return station < 0 ? Vec3d(0.0) : cave.stations[static_cast<size_t>(station)].position;
  };
  EXPECT_EQ(position("sink.1"), geology.sinks[0].position);
  EXPECT_EQ(position("Stream"), geology.sinks[1].position);
  EXPECT_EQ(position("spring.1"), geology.springs[0].position);
  EXPECT_EQ(position("entrance.1"), geology.entrances[0]);
  EXPECT_EQ(position("waypoint.1"), geology.waypoints[0]);
  EXPECT_TRUE(cave.stations[static_cast<size_t>(station_named(cave, "Stream"))].flags.sink);
  EXPECT_TRUE(cave.stations[static_cast<size_t>(station_named(cave, "spring.1"))].flags.spring);
}

/// The discharge that enters a station minus the one that leaves it.
double balance(const Network& cave, int station) {
  double sum = 0;
  for (const network::Leg& leg : cave.legs) {
    if (leg.to == station) sum += leg.discharge;
    if (leg.from == station) sum -= leg.discharge;
  }
  return sum;
}

TEST(Karst, WaterIsConservedFromSinksToTheSpring) {
  KarstOptions options = small_options();
  options.cost.reuse = 0.2;
  const Geology geology = small_geology();
  const Network cave = generate(geology, options);
  EXPECT_DOUBLE_EQ(balance(cave, station_named(cave, "sink.1")), -2);
  EXPECT_DOUBLE_EQ(balance(cave, station_named(cave, "sink.2")), -1);
  EXPECT_DOUBLE_EQ(balance(cave, station_named(cave, "spring.1")), 3);
  for (size_t i = 0; i < cave.stations.size(); ++i) {
    const network::StationFlags& flags = cave.stations[i].flags;
    if (!flags.sink && !flags.spring) {
      EXPECT_NEAR(balance(cave, static_cast<int>(i)), 0, 1e-12);
    }
  }
}

TEST(Karst, VadoseWaterFallsInPitchesAndGentleSlopes) {
  Geology geology = small_geology();
  geology.bounds.max.y = 200;
  geology.sinks[0].position.y = geology.sinks[1].position.y = 200;
  KarstOptions options = small_options();
  options.growth.dead_ends = 0;
  options.growth.loops = 0;
  options.samples.count = 2000;
  options.shape.wander = 0;
  options.shape.leg_length = 1;  // So that each passage has places for pitches.
  int pitches = 0;
  double drop = 0;
  const Network cave = generate(geology, options);
  for (const network::Leg& leg : cave.legs) {
    if (leg.stage != network::Stage::vadose) continue;
    const Vec3d way = leg_vector(cave, leg);
    drop -= way.y;
    const double across = std::hypot(way.x, way.z);
    if (across < 1e-9 && way.y < -1) ++pitches;
    // A tenth of a pitch is too low for one and makes the slope steeper.
    const double most = std::tan(options.shape.vadose_slope) * across + 0.1 * options.shape.pitch;
    if (across > 1e-9) {
      EXPECT_LT(-way.y, most + 1e-9);
    }
  }
  EXPECT_GT(drop, 250);  // Two sinks, 200 m above the table, whose ways may join.
  EXPECT_GT(pitches, 5);
}

TEST(Karst, PhreaticPassagesLoopBelowTheTable) {
  KarstOptions options = small_options();
  options.growth.dead_ends = 0;
  options.shape.looping = 0.3;
  options.shape.wander = 0;
  const auto mean_height = [&] {
    const Network cave = generate(small_geology(), options);
    double sum = 0, total = 0;
    for (const network::Leg& leg : cave.legs) {
      if (leg.stage != network::Stage::phreatic) continue;
      const double metres = leg_vector(cave, leg).length();
      total += metres;
      sum += 0.5 * metres *
             (cave.stations[static_cast<size_t>(leg.from)].position.y +
              cave.stations[static_cast<size_t>(leg.to)].position.y);
    }
    return sum / total;
  };
  const double looping = mean_height();
  options.shape.looping = 0;
  EXPECT_LT(looping, mean_height() - 0.5);
}

TEST(Karst, FormerWaterTablesLeaveTiers) {
  const Preset& preset = find_preset("tiers");
  const Network cave = generate(preset.geology, preset.options);
  std::array<double, 3> length{};
  std::array<double, 3> height{};
  for (const network::Leg& leg : cave.legs) {
    ASSERT_TRUE(leg.tier >= 0 && leg.tier < 3);
    if (leg.stage != network::Stage::phreatic) continue;
    const double metres = leg_vector(cave, leg).length();
    length[static_cast<size_t>(leg.tier)] += metres;
    height[static_cast<size_t>(leg.tier)] +=
        metres * cave.stations[static_cast<size_t>(leg.from)].position.y;
  }
  for (size_t tier = 0; tier < 3; ++tier) {
    ASSERT_GT(length[tier], 300) << tier;
    height[tier] /= length[tier];
  }
  EXPECT_LT(height[0] + 20, height[1]);
  EXPECT_LT(height[1] + 20, height[2]);
}

TEST(Karst, BedsAttractPassages) {
  KarstOptions options = small_options();
  options.growth.sinks = 0;
  options.growth.waypoints = 12;
  options.growth.gamma = 2;
  options.samples.on_beds = 0;  // Only the cost attracts.
  options.shape = {.wander = 0, .looping = 0};
  Geology geology;
  geology.bounds = Box3d(Vec3d(-100, -40, -100), Vec3d(100, 40, 100));
  geology.beds = {{.point = Vec3d(0, 10, 0), .dip = 0.2, .dip_azimuth = 1}};
  const auto mean_distance = [&](double weight) {
    options.cost.bed = weight;
    double sum = 0;
    const Network cave = generate(geology, options);
    for (const network::Station& s : cave.stations)
      sum += std::abs(s.position.y - geology.beds[0].height_at(s.position.x, s.position.z));
    return sum / static_cast<double>(cave.stations.size());
  };
  EXPECT_LT(mean_distance(20), 0.7 * mean_distance(0));
}

/// The part of a network's length for whose middles a condition holds, over several seeds.
template <class Condition>
double part_of_length(const Geology& geology, KarstOptions options, const Condition& holds) {
  double part = 0, total = 0;
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    options.seed = seed;
    const Network cave = generate(geology, options);
    for (const network::Leg& leg : cave.legs) {
      const Vec3d way = leg_vector(cave, leg);
      const Vec3d middle = cave.stations[static_cast<size_t>(leg.from)].position + way * 0.5;
      total += way.length();
      if (holds(middle)) part += way.length();
    }
  }
  return part / total;
}

/// Ways between random points of one bed.
Geology bed_geology() {
  Geology geology;
  geology.bounds = Box3d(Vec3d(-100, -20, -100), Vec3d(100, 20, 100));
  geology.beds = {{.point = Vec3d(0.0)}};
  return geology;
}

KarstOptions bed_options() {
  KarstOptions options = small_options();
  options.growth.sinks = 0;
  options.growth.waypoints = 12;
  options.growth.gamma = 2;
  options.shape = {.wander = 0, .looping = 0};
  return options;
}

TEST(Karst, FaultsAttractPassages) {
  const auto near_fault = [](const Vec3d& p) { return std::abs(p.x) < 8; };
  Geology geology = bed_geology();
  const double without = part_of_length(geology, bed_options(), near_fault);
  geology.faults = {{.point = Vec3d(0.0), .azimuth = 0, .width = 8}};
  KarstOptions options = bed_options();
  options.cost.fracture = 6;
  EXPECT_GT(part_of_length(geology, options, near_fault), 1.4 * without);
}

TEST(Karst, PermeableRockAttractsPassagesAndTightRockRepelsThem) {
  const auto inside = [](const Vec3d& p) { return p.length() < 50; };
  Geology geology = bed_geology();
  KarstOptions options = bed_options();
  options.cost.permeability = 4;
  options.samples.in_permeable = 0;  // Only the cost attracts.
  geology.waypoints = {Vec3d(-90, 0, -60), Vec3d(90, 0, -60), Vec3d(-90, 0, 60),
                       Vec3d(90, 0, 60),   Vec3d(0, 0, -90),  Vec3d(0, 0, 90)};
  const double plain = part_of_length(geology, options, inside);
  geology.permeable = {{.center = Vec3d(0.0), .radius = 70, .strength = 1}};
  EXPECT_GT(part_of_length(geology, options, inside), 1.1 * plain);
  geology.permeable[0].strength = -1;
  EXPECT_LT(part_of_length(geology, options, inside), 0.8 * plain);
}

TEST(Karst, GhostRockAttractsPassages) {
  const auto inside = [](const Vec3d& p) { return std::abs(p.z) < 20; };
  Geology geology = bed_geology();
  KarstOptions options = bed_options();
  options.cost.ghost_rock = 6;
  options.samples.in_permeable = 0;
  const double without = part_of_length(geology, options, inside);
  geology.ghost_rock = {field::make("box", {{"size", Vec3d(200, 40, 40)}})};
  EXPECT_GT(part_of_length(geology, options, inside), 1.4 * without);
}

TEST(Karst, JointsDirectPassages) {
  const Preset& preset = find_preset("maze_rectilinear");
  KarstOptions options = preset.options;
  Geology geology = preset.geology;
  geology.fractures.resize(2);
  for (FractureFamily& family : geology.fractures) family.spread = 0.06;
  options.shape.zigzag = 1;
  options.shape.wander = 0;
  double aligned = 0;
  double total = 0;
  const Network cave = generate(geology, options);
  for (const network::Leg& leg : cave.legs) {
    const Vec3d way = leg_vector(cave, leg);
    const double azimuth = network::folded_azimuth(way);
    if (std::isnan(azimuth)) continue;
    const double length = std::hypot(way.x, way.z);
    total += length;
    for (const FractureFamily& family : geology.fractures) {
      const double difference = std::abs(azimuth - family.azimuth);
      if (std::min(difference, kPi - difference) < 0.2) aligned += length;
    }
  }
  EXPECT_GT(aligned, 0.7 * total);  // Directions at random would give 0.25.
}

TEST(Karst, RejectsInvalidInput) {
  const auto faulty = [](const auto& change) {
    Geology geology = small_geology();
    KarstOptions options = small_options();
    change(geology, options);
    EXPECT_THROW(generate(geology, options), Error);
  };
  using G = Geology;
  using O = KarstOptions;
  faulty([](G& g, O&) { g.bounds.max.x = std::nan(""); });
  faulty([](G& g, O&) { g.bounds.max.y = g.bounds.min.y; });
  faulty([](G& g, O&) { g.bounds = Box3d(); });
  faulty([](G& g, O&) { g.sinks[0].position.x = kInfinity; });
  faulty([](G& g, O&) { g.sinks[0].discharge = 0; });
  faulty([](G& g, O&) { g.springs.clear(); });
  faulty([](G& g, O&) { g.springs[0].tier = 1; });
  faulty([](G& g, O&) { g.beds[0].dip = kPi / 2; });
  faulty([](G& g, O&) { g.fractures = {{.spacing = 0}}; });
  faulty([](G& g, O&) { g.fractures = {{.spread = -1}}; });
  faulty([](G& g, O&) { g.permeable = {{.radius = 0}}; });
  faulty([](G& g, O&) { g.faults = {{.width = std::nan("")}}; });
  faulty([](G& g, O&) { g.sinks[0].name = g.springs[0].name = "same"; });
  faulty([](G&, O& o) { o.samples.count = -1; });
  faulty([](G&, O& o) { o.samples.on_beds = 0.95; });
  faulty([](G&, O& o) { o.cost.heterogeneity = std::nan(""); });
  faulty([](G&, O& o) { o.shape.leg_length = 0; });
  faulty([](G&, O& o) { o.growth.loop_most = 1; });
  faulty([](G& g, O& o) {
    g.sinks.clear();
    g.springs.clear();
    o.growth.sinks = 0;
  });
}

TEST(Karst, RefusesGeologyInWhichNoWaterFlows) {
  const auto message = [](const auto& change) -> std::string {
    Geology geology = small_geology();
    change(geology);
    try {
      generate(geology, small_options());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  using G = Geology;
  has(message([](G& g) { g.sinks[0].position.y = -30; }), "lies below all springs");
  has(message([](G& g) { g.sinks[0].position = g.springs[0].position; }), "are in the same place");
  has(message([](G& g) { g.sinks[0].position.x = -400; }), "is outside the rock, which reaches");
  has(message([](G& g) { g.waypoints.push_back(Vec3d(0, 200, 0)); }), "a waypoint at (0, 200, 0)");
  has(message([](G& g) { g.sinks[0].name = "a b"; }), "contains a blank");
  has(message([](G& g) {
        g.water_tables = {{.point = Vec3d(0, -15, 0)}, {.point = Vec3d(0, -30, 0)}};
      }),
      "water table 2 lies below water table 1");
  has(message([](G& g) {
        g.solid = field::make("sphere", {{"radius", 30.0}});
      }),
      "is outside the solid 'rock'");
}

TEST(Karst, WorksWithFewSamples) {
  KarstOptions options = small_options();
  options.samples.count = 2;
  options.growth.dead_ends = 3;
  const Network cave = generate(small_geology(), options);
  EXPECT_GE(cave.legs.size(), 2u);
  options.samples.neighbours = 1;
  EXPECT_EQ(network::measure(generate(small_geology(), options)).components, 1);
}

TEST(Presets, AreFoundByName) {
  EXPECT_STREQ(find_preset("conduit").name, "conduit");
  try {
    find_preset("condiut");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.hint(), "did you mean 'conduit'?");
  }
}

}  // namespace
}  // namespace vug::karst
