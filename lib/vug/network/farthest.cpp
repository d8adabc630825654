// SPDX-License-Identifier: Apache-2.0
#include <vug/network/farthest.h>

#include <algorithm>
#include <queue>
#include <utility>

namespace vug::network {

int first_station(const Network& network) {
  if (network.stations.empty()) return -1;
  const auto found = std::find_if(network.stations.begin(), network.stations.end(),
                                  [](const Station& each) { return each.flags.entrance; });
  return found == network.stations.end() ? 0 : static_cast<int>(found - network.stations.begin());
}

int farthest_station(const Network& network, int from) {
  const std::vector<std::vector<int>> legs = legs_at_stations(network);
  std::vector<double> ways(network.stations.size(), -1);
  using Reached = std::pair<double, int>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  open.push({0, from});
  while (!open.empty()) {
    const auto [way, at] = open.top();
    open.pop();
    if (ways[static_cast<size_t>(at)] >= 0) continue;
    ways[static_cast<size_t>(at)] = way;
    for (const int index : legs[static_cast<size_t>(at)]) {
      const Leg& leg = network.legs[static_cast<size_t>(index)];
      const int other = leg.from == at ? leg.to : leg.from;
      if (ways[static_cast<size_t>(other)] < 0)
        open.push({way + leg_vector(network, leg).length(), other});
    }
  }
  return static_cast<int>(std::max_element(ways.begin(), ways.end()) - ways.begin());
}

}  // namespace vug::network
