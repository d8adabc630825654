// SPDX-License-Identifier: Apache-2.0
// The legs of a network as passages: chains that continue straight on at junctions.
#pragma once

#include <vug/network/network.h>

#include <vector>

namespace vug::passages {

/// Stations in order and the legs between them. Stations at the same position count as one, which
/// has the smallest index of them.
struct Chain {
  std::vector<int> stations;  ///< One more than legs.
  std::vector<int> legs;
  bool start_meets = false;  ///< Whether the first station lies inside another passage.
  bool end_meets = false;

  /// Whether station `i` of the chain lies inside another passage that ends this one.
  bool meets_at(size_t i) const {
    return (i == 0 && start_meets) || (i + 1 == stations.size() && end_meets);
  }
};

/// The passages of a network, in the order of their first legs. At each station the two legs that
/// continue each other best, by their directions, belong to one passage; the other passages end
/// there. Legs that are repeated, have no length or run over the surface are omitted. The network
/// must be valid (network::require_valid).
std::vector<Chain> chains(const network::Network& network);

}  // namespace vug::passages
