// SPDX-License-Identifier: Apache-2.0
// A scored network with its measures, as text and as JSON.
#pragma once

#include <vug/network/score.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace vug::network {

/// A network's measures and its place among real caves.
struct ScoredNetwork {
  std::string name;  ///< For titles: of the network or of its file.
  Metrics metrics;
  SectionSummary sections;
  Realism realism;
};

/// Measures and scores a network. Throws Error(bad_input) if no leg is part of the cave (legs over
/// the surface and duplicates are not), and like require_valid.
ScoredNetwork scored(const Network& network, const std::string& name);

/// The counts, the overall score, a line for each criterion with its value, its percentile and the
/// range of real caves, and the sentences of advice.
std::string score_table(const ScoredNetwork& cave);

/// The same with all quantiles. Undefined values are null, percentiles and realism are in 0..1, and
/// lengths in metres.
nlohmann::ordered_json score_json(const ScoredNetwork& cave);

}  // namespace vug::network
