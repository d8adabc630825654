// SPDX-License-Identifier: Apache-2.0
// Whether a person passes through a cave, for `vug measure --clearance`.
#pragma once

#include <vug/building/builder.h>
#include <vug/volume/clearance.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace vug::delivery {

struct ClearanceRequest {
  std::string mesh;     ///< Empty: the first mesh.
  std::string network;  ///< Empty: the first network.
  std::string from;     ///< A station; empty: the first entrance, else the first station.
  std::string to;       ///< A station; empty: the one farthest along the legs from `from`.
  volume::UprightCapsule body{};
};

struct ClearanceReport {
  volume::UprightCapsule body{};
  std::string from, to;  ///< Stations.
  bool passes = false;   ///< Whether the body can move from one to the other.
  /// The diameter in metres of the widest body of this height, or of a ball if it is wider, that
  /// passes; between `passes` as 0 and kWidestBody, to 2 cm.
  double widest = 0;
  int stations = 0;                  ///< Stations of the network, without those on the surface.
  std::vector<std::string> missing;  ///< Those that the body cannot reach from `from`.
};

/// The diameter in metres beyond which wider bodies are not tried.
inline constexpr double kWidestBody = 3;

/// Throws Error(bad_input) if the shot has no such mesh or network, or the mesh does not come from
/// a volume.
ClearanceReport measure_clearance(building::Builder& builder, const ClearanceRequest& request);

std::string to_table(const ClearanceReport& report);
nlohmann::ordered_json to_json(const ClearanceReport& report);

}  // namespace vug::delivery
