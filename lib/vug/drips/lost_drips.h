// SPDX-License-Identifier: Apache-2.0
// Drips that were added or moved by hand and do not drip.
#pragma once

#include <vug/drips/build_graph.h>

#include <string>
#include <vector>

namespace vug::drips {

/// An edit without effect, and the reason.
struct LostDrip {
  SourceLocation where;  ///< The place of the edit in its text.
  std::string message;
  std::string hint;
};

/// The added and moved drips of a graph, or of ways_of_edits, whose water ends in a sink, or runs
/// into that of another drip before it drips. Water that runs down a wall to a floor is not lost.
std::vector<LostDrip> lost_drips(const Graph& graph, const GraphOptions& options);

}  // namespace vug::drips
