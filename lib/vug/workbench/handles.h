// SPDX-License-Identifier: Apache-2.0
// Draggable handles of a node on the facade's plane: the lines of modeller/lines.h and the edges of
// windows in all instances of the node.
#pragma once

#include <vug/modeller/edit.h>
#include <vug/modeller/lines.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::workbench {

/// One handle of one instance. Equal indices in different instances are the same number, so that a
/// drag of one moves all of them.
struct Handle {
  size_t index = 0;     ///< Among the handles of the node; lines come first, as `move` counts them.
  size_t instance = 0;  ///< Among facade::placements of the node.
  bool upright = true;  ///< It moves along x; else along y.
  bool line = true;     ///< A line of the node; else an edge that sets a size.
  std::string number;   ///< The free number that it sets.
  double at = 0;        ///< Position in the node's own frame, metres.
  double origin = 0;    ///< Sizes: the position in the node's frame that they are measured from.
  /// The segment on the facade's plane, metres.
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The node whose numbers a user changes if `node` is selected: the node itself if it has free
/// numbers, else the grid that its rule leads to, else the nearest ancestor that has some. kWhole
/// if there is none.
int numbers_node(const modeller::FacadeState& state, int node);

/// The handles of the node's own numbers.
std::vector<Handle> handles(const modeller::FacadeState& state, int node);

/// The nearest handle within `tolerance` metres of a point; an edge before a line.
std::optional<Handle> handle_at(const std::vector<Handle>& handles, double x, double y,
                                double tolerance);

/// The position in the node's own frame of a point on the facade's plane, as seen by the handle's
/// instance: a motion to the left in a mirrored instance is one to the right in the node.
double own_position(const modeller::FacadeState& state, int node, const Handle& handle, double x,
                    double y);

/// The edit that moves the handle to a position in the node's own frame.
modeller::Edit drag_edit(const modeller::FacadeState& state, int node, const Handle& handle,
                         double to);

}  // namespace vug::workbench
