// SPDX-License-Identifier: Apache-2.0
// Small geologies and properties of networks for tests of the karst generator.
#pragma once

#include <vug/base/hash.h>
#include <vug/karst/generate.h>
#include <vug/karst/presets.h>

namespace vug::karst {

/// One bed, a level water table, two sinks and a spring.
inline Geology small_geology() {
  Geology g;
  g.bounds = Box3d(Vec3d(-100, -40, -100), Vec3d(100, 30, 100));
  g.beds = {{.point = Vec3d(0, -5, 0)}};
  g.water_tables = {{.point = Vec3d(0, 0, 0)}};
  g.sinks = {{.position = Vec3d(-80, 30, -60), .discharge = 2},
             {.position = Vec3d(-70, 30, 70), .discharge = 1}};
  g.springs = {{.position = Vec3d(90, -2, 0)}};
  return g;
}

inline KarstOptions small_options(uint64_t seed = 1) {
  KarstOptions options;
  options.seed = seed;
  options.samples.count = 800;
  options.growth.dead_ends = 12;
  return options;
}

/// A digest of all that a network contains.
inline Digest digest_of(const network::Network& network) {
  Hasher hasher;
  for (const network::Station& station : network.stations) {
    hasher.add(station.name).add_value(station.flags);
    for (int axis = 0; axis < 3; ++axis) hasher.add_value(station.position[axis]);
  }
  for (const network::Leg& leg : network.legs) {
    hasher.add_value(leg.from).add_value(leg.to).add_value(leg.stage).add_value(leg.tier);
    hasher.add_value(leg.discharge).add(leg.survey);
  }
  return hasher.finish();
}

/// The index of the station with a name, or -1.
inline int station_named(const network::Network& network, const std::string& name) {
  for (size_t i = 0; i < network.stations.size(); ++i)
    if (network.stations[i].name == name) return static_cast<int>(i);
  return -1;
}

}  // namespace vug::karst
