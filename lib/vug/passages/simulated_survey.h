// SPDX-License-Identifier: Apache-2.0
// The survey that cavers would make of a field: legs along a network, with the distances to the
// walls and splays at each station, as a test of import against export.
#pragma once

#include <vug/field/field.h>
#include <vug/network/network.h>
#include <vug/survey/survey.h>

#include <cstdint>

namespace vug::passages {

struct SimulationOptions {
  double longest_leg = 5;  ///< Metres; longer legs are divided into equal ones. Above 0.
  int splays = 24;         ///< At each station, 0 to 1000.
  /// The largest angle in radians between a splay and the plane across the passage, 0 to pi / 4.
  double tilt = 0.15;
  double reach = 100;  ///< Metres; walls that are farther away are not measured. Above 0.
  uint64_t seed = 0;   ///< The seed of the directions of splays.
};

struct SimulatedSurvey {
  /// In survey space about Network::origin. Legs and tubes run along the chains of the network.
  survey::Survey survey;
  /// Stations in the rock, too far from the air. They have neither a cross-section nor splays.
  int in_rock = 0;
};

/// Measures the passages of a field along the underground legs of a network (see `chains`). The
/// passages are the side of the surface on which most of the stations lie, so a field of rock and
/// one of air have the same survey. As in a real survey, each station sees the next one: stations
/// in the rock or at a wall are moved into the air if it is within 3 m, and further stations lead
/// the line around bends. Left and right are horizontal where the passage is less steep than 50
/// degrees, up and down perpendicular to the passage. The directions of a station's splays have
/// equal angles about the passage, from a random one, and a random tilt. The result is the same for
/// any number of threads. Throws Error(bad_input) for a network without legs or with invalid data,
/// and for options out of range.
SimulatedSurvey simulate_survey(const field::Field& field, const network::Network& network,
                                const SimulationOptions& options = {});

}  // namespace vug::passages
