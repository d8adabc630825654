// SPDX-License-Identifier: Apache-2.0
// Any bytes as the two files of a karst network: the nodes, a zero byte, the links. They are
// refused as bad input, or yield a valid network that has finite metrics and is read again from
// what is written.
#include "require.h"
#include "target.h"

#include <vug/base/error.h>
#include <vug/network/dat.h>
#include <vug/network/metrics.h>
#include <vug/network/survey_space.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace {

using namespace vug;
using network::Network;

/// Stations in survey space.
Vec3d position(const Network& network, size_t station) {
  return network.origin + network::to_survey(network.stations[station].position);
}

void check_copy(const Network& network) {
  const Network again = network::parse_dat({nodes_dat(network), "again_nodes.dat"},
                                           {links_dat(network), "again_links.dat"});
  require(again.stations.size() == network.stations.size(), "the copy has all stations");
  require(again.legs.size() == network.legs.size(), "the copy has all legs");
  for (size_t i = 0; i < network.stations.size(); ++i)
    require((position(again, i) - position(network, i)).length() < 1e-5, "positions are kept");
  for (size_t i = 0; i < network.legs.size(); ++i)
    require(again.legs[i].from == network.legs[i].from && again.legs[i].to == network.legs[i].to,
            "legs are kept");
}

void check_metrics(const Network& network) {
  const network::Metrics metrics = measure(network);
  require(metrics.cycles >= 0 && metrics.components >= 0, "counts");
  require(std::isfinite(metrics.length) && metrics.length >= 0, "the length is finite");
}

}  // namespace

VUG_FUZZ_TARGET(nodes_links) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const size_t end = std::min(bytes.find('\0'), size);
  const std::string_view links = end < size ? bytes.substr(end + 1) : std::string_view();
  Network network;
  try {
    network =
        network::parse_dat({bytes.substr(0, end), "fuzz_nodes.dat"}, {links, "fuzz_links.dat"});
  } catch (const Error& error) {
    require(error.code() == ErrorCode::bad_input, "errors blame the input");
    require(error.where().known() && error.where().file.starts_with("fuzz_"),
            "errors name the line");
    return;
  }
  require_valid(network);
  check_copy(network);
  check_metrics(network);
}
