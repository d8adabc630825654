// SPDX-License-Identifier: Apache-2.0
#include <vug/network/find_station.h>
#include <vug/shot/passage_params.h>

namespace vug::shot {

passages::PassageOptions PassageParams::options() const {
  passages::PassageOptions out = PassageLine::options();
  out.chamber = chamber;
  out.fillet = fillet;
  if (section || !sections.empty()) out.rules = sections;
  if (section) out.section = *section;
  return out;
}

std::vector<int> stations_named(const network::Network& network,
                                const std::vector<std::string>& names) {
  std::vector<int> out;
  for (const std::string& name : names) out.push_back(network::find_station(network, name));
  return out;
}

}  // namespace vug::shot
