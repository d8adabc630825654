// Lines of a node that can be dragged.
#pragma once

#include <vug/modeller/facade_state.h>

namespace vug::modeller {

struct Line {
  bool upright = true;
  double at = 0;       ///< Metres from the node's left edge, or from its lower one.
  std::string number;  ///< The free number that it is drawn from: "heights", "dx", ...
  size_t index = 0;    ///< Which line of that number, from 0.
};

/// Between rows and columns whose sizes are free, on both sides of a free middle, and where the
/// columns and rows of a grid begin. In the node's own frame: what is mirrored runs from the right
/// to the left.
std::vector<Line> lines(const FacadeState& state, int node);

/// The numbers with the line at another place. Other lines stay, but for those of a regular grid:
/// its first one takes all along, any other changes the distance of all.
facade::NumberValues move_line(const FacadeState& state, int node, const Line& line, double to);

}  // namespace vug::modeller
