// SPDX-License-Identifier: Apache-2.0
// The stations of a network in the space of its scene, for `vug survey SCENE --stations`.
#pragma once

#include <string>

namespace vug::cli {

/// Loads a scene and prints the stations of the network of that name (empty: the first), with their
/// positions in metres of the scene, flags and further names; as JSON if `json` is set.
/// Error(bad_input) for unknown names and scenes without networks.
void print_network_stations(const std::string& scene, const std::string& network, bool json);

}  // namespace vug::cli
