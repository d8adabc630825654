// SPDX-License-Identifier: Apache-2.0
#include "passage_samples.h"

#include <vug/passages/breakdown/pile.h>
#include <vug/passages/water/water_body.h>

#include <cmath>

namespace vug::passages {

network::Network network_of(const std::vector<Vec3d>& stations,
                            const std::vector<std::pair<int, int>>& legs) {
  network::Network out;
  for (const Vec3d& p : stations) {
    network::Station station;
    station.position = p;
    out.stations.push_back(station);
  }
  for (const auto& [from, to] : legs) {
    network::Leg leg;
    leg.from = from;
    leg.to = to;
    out.legs.push_back(leg);
  }
  return out;
}

network::Network with_radius(network::Network network, double radius) {
  for (network::Station& station : network.stations)
    station.section = network::CrossSection{radius, radius, radius, radius};
  return network;
}

network::Network random_cave(uint64_t seed, int legs) {
  RandomStream random(RandomKey(seed).at("random cave"));
  network::Network out = network_of({{0, 0, 0}}, {});
  double heading = 0;
  for (int i = 0; i < legs; ++i) {
    // A new branch now and then; otherwise the last passage continues.
    const bool branch = i > 2 && random.uniform() < 0.15;
    const int from = branch ? static_cast<int>(random.below(static_cast<uint32_t>(i)))
                            : static_cast<int>(out.stations.size()) - 1;
    heading += branch ? random.uniform(0, 6) : random.uniform(-0.8, 0.8);
    const bool shaft = random.uniform() < 0.1;
    const double dip = shaft ? -1.4 : random.uniform(-0.3, 0.3), length = random.uniform(4, 12);
    network::Station station;
    station.position =
        out.stations[static_cast<size_t>(from)].position +
        Vec3d(std::cos(heading) * std::cos(dip), std::sin(dip), std::sin(heading) * std::cos(dip)) *
            length;
    const auto wall = [&] { return std::exp(0.5 * random.normal()); };
    if (random.uniform() < 0.8) {
      network::CrossSection walls;
      walls.left = wall();
      walls.right = wall();
      walls.up = wall();
      if (random.uniform() < 0.9) walls.down = wall();
      station.section = walls;
    }
    network::Leg leg;
    leg.from = from;
    leg.to = static_cast<int>(out.stations.size());
    leg.stage = static_cast<network::Stage>(random.below(3));
    out.stations.push_back(station);
    out.legs.push_back(leg);
  }
  return out;
}

const std::vector<PassageCase>& passage_cases() {
  static const std::vector<PassageCase> cases = [] {
    std::vector<PassageCase> all;
    for (const uint64_t seed : {1U, 2U})
      all.push_back({"default rules " + std::to_string(seed), passages(random_cave(seed, 60))});
    PassageOptions meandering;
    meandering.meanders.sinuosity = 1.5;
    meandering.chamber = 2;
    meandering.fillet = 1;
    all.push_back({"meanders", passages(random_cave(3, 60), meandering)});
    all.push_back({"stream", stream_body(random_cave(5, 40), {}, {})});
    all.push_back({"sediment", sediment_body(random_cave(6, 40), {}, {.depth = 0.4}, 0.3)});
    all.push_back({"ponds", pond_body(random_cave(7, 40), {}, {}, {}, 1, 0.3)});
    const Vault roof = vault({.at = {0, 7, 0}, .span = 8, .length = 11, .strength = 0.6});
    all.push_back({"vault", vault_body(roof)});
    all.push_back({"breakdown", breakdown_body(roof, {}, 0.8)});
    for (const SectionKind* kind : sections()) {
      PassageOptions options;
      options.rules = {};
      options.section = make_family(kind->info.name);
      all.push_back({kind->info.name, passages(random_cave(4, 25), options)});
    }
    return all;
  }();
  return cases;
}

Vec3d random_vector(RandomStream& random, double reach) {
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}

Vec3d point_near(const field::Field& field, RandomStream& random) {
  const Box3d box = grown(field.bounds(), 2);
  Vec3d p = box.center() + 0.5 * box.size() * random_vector(random, 1);
  // Towards the nearest passage, to random distances around its surface.
  for (int i = 0; i < 12; ++i) {
    const field::Gradient g = field.gradient(p);
    if (g.value < 3 || !(g.gradient.length() > 0.1)) break;
    p -= g.gradient.normalized() * (g.value - random.uniform(-1, 2));
  }
  return p + random_vector(random, 0.3);
}

}  // namespace vug::passages
