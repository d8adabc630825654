// SPDX-License-Identifier: Apache-2.0
// Moves an edge of windows, or of a free-standing element, to a position that the picture suggests.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

/// One of the edges of a rectangle that starts at `low` and has the size `size`.
struct Edge {
  int origin, room, low, size;
  bool is_low;

  int window_begin(int min_size) const { return origin + (is_low ? 0 : low + min_size); }
  int window_end(int min_size) const {
    return origin + (is_low ? low + size - min_size : room) + 1;
  }
  int place() const { return origin + (is_low ? low : low + size); }
};

bool redraw(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const auto fits = [&](int i) { return is_terminal(context, state, i); };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool along_x = forward.flip(), low_edge = forward.flip();
  back.flip(along_x), back.flip(low_edge);
  const int min_size = context.model.limits().min_size;
  const Node& node = state.tree[i];
  const Node& above = state.tree[state.tree.parent(i)];
  const int stands = along_x ? node.x : node.y;
  const int first_line = along_x ? above.left[0] : above.top[0];
  const Area& area = state.area(i);
  const inference::DiscreteDistribution& profile =
      along_x ? (low_edge ? context.hints.left : context.hints.right)
              : (low_edge ? context.hints.top : context.hints.bottom);
  const Edge edge{along_x ? state.instance(area, 0).x : area.y, along_x ? area.width : area.height,
                  context.model.in_grid(node) ? first_line : stands,
                  along_x ? node.width : node.height, low_edge};
  if (edge.low + edge.size > edge.room) return false;  // A kind without instances.
  const int begin = edge.window_begin(min_size), end = edge.window_end(min_size);
  back.among(profile, begin, end, edge.place());
  const int by = forward.among(profile, begin, end) - edge.place();
  return forward.possible() && move_edge(context, state, i, along_x, low_edge, by);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(redraw) {
  return {
      {"redraw", "move", "Moves an edge of windows or a door to an edge in the picture.", "", {}},
      3,
      redraw};
}
