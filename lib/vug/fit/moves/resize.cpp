// SPDX-License-Identifier: Apache-2.0
// Moves one edge of the windows of a grid, or of a free-standing element, by a few pixels.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

bool resize(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const auto fits = [&](int i) { return is_terminal(context, state, i); };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool along_x = forward.flip(), low_edge = forward.flip();
  back.flip(along_x), back.flip(low_edge);
  const int by = step(forward, back);  // Change of the size.
  return move_edge(context, state, i, along_x, low_edge, low_edge ? -by : by);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(resize) {
  return {{"resize", "move", "Moves an edge of windows, a door or a shop by a few pixels.", "", {}},
          3,
          resize};
}
