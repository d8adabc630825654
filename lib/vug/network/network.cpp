// SPDX-License-Identifier: Apache-2.0
#include <vug/network/network.h>

#include <fmt/format.h>
#include <vug/base/error.h>

#include <cmath>

namespace vug::network {
namespace {

bool is_finite(const Vec3d& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

[[noreturn]] void fail(const Station& station, size_t index, const char* fault) {
  throw Error(ErrorCode::bad_input,
              fmt::format("station {} ('{}') has {}", index, station.name, fault), {},
              "coordinates and distances must be finite, distances to walls not negative");
}

bool is_valid(const CrossSection& section) {
  for (const auto& distance : {section.left, section.right, section.up, section.down})
    if (distance && !(std::isfinite(*distance) && *distance >= 0)) return false;
  return true;
}

}  // namespace

std::vector<std::vector<int>> legs_at_stations(const Network& network) {
  std::vector<std::vector<int>> legs(network.stations.size());
  for (size_t i = 0; i < network.legs.size(); ++i) {
    legs[static_cast<size_t>(network.legs[i].from)].push_back(static_cast<int>(i));
    legs[static_cast<size_t>(network.legs[i].to)].push_back(static_cast<int>(i));
  }
  return legs;
}

Vec3d leg_vector(const Network& network, const Leg& leg) {
  return network.stations[static_cast<size_t>(leg.to)].position -
         network.stations[static_cast<size_t>(leg.from)].position;
}

void require_valid(const Network& network) {
  for (size_t i = 0; i < network.stations.size(); ++i) {
    const Station& station = network.stations[i];
    if (!is_finite(station.position)) fail(station, i, "a position that is not finite");
    for (const Vec3d& splay : station.splays)
      if (!is_finite(splay)) fail(station, i, "a splay that is not finite");
    if (station.section && !is_valid(*station.section))
      fail(station, i, "an invalid cross-section");
  }
  const auto count = static_cast<int>(network.stations.size());
  for (size_t i = 0; i < network.legs.size(); ++i) {
    const Leg& leg = network.legs[i];
    if (leg.from < 0 || leg.from >= count || leg.to < 0 || leg.to >= count)
      throw Error(ErrorCode::bad_input,
                  fmt::format("leg {} joins stations {} and {}, but the network has {} stations", i,
                              leg.from, leg.to, count),
                  {}, "stations count from 0");
  }
}

}  // namespace vug::network
