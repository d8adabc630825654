// SPDX-License-Identifier: Apache-2.0
// Draggable lines of a node.
#pragma once

#include <vug/modeller/facade_state.h>

namespace vug::modeller {

struct Line {
  bool upright = true;
  double at = 0;       ///< Metres from the node's left or lower edge.
  std::string number;  ///< The free number that the line represents: "heights", "dx", ...
  size_t index = 0;    ///< Index among the lines of that number, from 0.
};

/// Lines between rows and columns with free sizes, on both sides of a free middle, and at the start
/// of each column and row of a grid. Positions are in the node's own frame, which runs from right
/// to left in a mirrored node.
std::vector<Line> lines(const FacadeState& state, int node);

/// The numbers after moving the line to `to`. Other lines keep their positions, except in a regular
/// grid: moving the first line shifts all of them, moving another one changes the spacing.
facade::NumberValues move_line(const FacadeState& state, int node, const Line& line, double to);

}  // namespace vug::modeller
