// SPDX-License-Identifier: Apache-2.0
#include <vug/base/shortest_paths.h>
#include <vug/network/farthest.h>

#include <algorithm>
#include <cmath>

namespace vug::network {

int first_station(const Network& network) {
  if (network.stations.empty()) return -1;
  const auto found = std::find_if(network.stations.begin(), network.stations.end(),
                                  [](const Station& each) { return each.flags.entrance; });
  return found == network.stations.end() ? 0 : static_cast<int>(found - network.stations.begin());
}

int farthest_station(const Network& network, int from) {
  const std::vector<std::vector<int>> legs = legs_at_stations(network);
  const auto for_each_arc = [&](int station, const auto& relax) {
    for (const int index : legs[static_cast<size_t>(station)]) {
      const Leg& leg = network.legs[static_cast<size_t>(index)];
      relax(leg.from == station ? leg.to : leg.from, index, leg_vector(network, leg).length());
    }
  };
  int farthest = from;
  double longest = 0;
  const SearchTree ways = shortest_paths(network.stations.size(), from, for_each_arc,
                                         [](int) { return Visit::expand; });
  for (size_t i = 0; i < ways.cost.size(); ++i)
    if (std::isfinite(ways.cost[i]) && ways.cost[i] > longest) {
      longest = ways.cost[i];
      farthest = static_cast<int>(i);
    }
  return farthest;
}

}  // namespace vug::network
