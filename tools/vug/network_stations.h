// SPDX-License-Identifier: Apache-2.0
// The networks of a scene, for `vug survey SCENE`: as surveys, and their stations in the space of
// the scene.
#pragma once

#include "scene_options.h"

#include <vug/survey/survey.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::cli {

/// Loads a scene, of which no volume is built, and returns the network of that name (empty: the
/// first) as a survey. Error(bad_input) for unknown names, scenes without networks, and outputs
/// that the scene reads.
survey::Survey network_survey(const SceneOptions& scene, const std::string& network,
                              const std::vector<std::filesystem::path>& outputs);

/// Loads a scene and prints the stations of the network of that name (empty: the first), with their
/// positions in metres of the scene, flags and further names; as JSON if `json` is set.
/// Error(bad_input) for unknown names and scenes without networks.
void print_network_stations(const SceneOptions& scene, const std::string& network, bool json);

}  // namespace vug::cli
