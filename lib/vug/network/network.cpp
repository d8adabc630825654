// SPDX-License-Identifier: Apache-2.0
#include <vug/network/network.h>

namespace vug::network {

std::vector<std::vector<int>> legs_at_stations(const Network& network) {
  std::vector<std::vector<int>> legs(network.stations.size());
  for (size_t i = 0; i < network.legs.size(); ++i) {
    legs[static_cast<size_t>(network.legs[i].from)].push_back(static_cast<int>(i));
    legs[static_cast<size_t>(network.legs[i].to)].push_back(static_cast<int>(i));
  }
  return legs;
}

}  // namespace vug::network
