// Moves one edge of windows, or of what stands by itself, to a place that the picture hints at.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

/// One of the four edges of a rectangle that begins at `low` and is `size` long.
struct Edge {
  const inference::Profile& profile;
  int origin, room, low, size;
  bool is_low;

  int window_begin(int least) const { return origin + (is_low ? 0 : low + least); }
  int window_end(int least) const { return origin + (is_low ? low + size - least : room) + 1; }
  int place() const { return origin + (is_low ? low : low + size); }
};

bool redraw(const Workshop& shop, State& state, Choices& forward, Choices& back) {
  const Rules& rules = shop.model.rules();
  Tree& tree = state.tree;
  const auto fits = [&](int i) { return rules.symbol(tree[i].symbol).terminal; };
  const int i = pick(state, forward, fits);
  if (i < 0) return false;
  tell_pick(state, back, i, fits);
  const bool along_x = forward.flip(), low_edge = forward.flip();
  back.flip(along_x), back.flip(low_edge);
  const int above = tree.parent(i), least = shop.model.limits().least;
  Node& node = tree[i];
  Node& grid = tree[above];
  const bool in_grid = static_cast<Op>(node.made_by) == Op::windows &&
                       rules.symbol(node.symbol).look == Look::window;
  Lines& lines = along_x ? grid.left : grid.top;
  const int count = !in_grid ? 0 : along_x ? grid.columns : grid.rows;
  int16_t& at = along_x ? node.x : node.y;
  int16_t& size = along_x ? node.width : node.height;
  const Area& area = state.area(i);
  const inference::Profile& profile = along_x ? (low_edge ? shop.hints.left : shop.hints.right)
                                              : (low_edge ? shop.hints.top : shop.hints.bottom);
  const Edge edge{profile,
                  along_x ? state.frame(area, 0).x : area.y,
                  along_x ? area.width : area.height,
                  in_grid ? lines[0] : at,
                  size,
                  low_edge};
  if (edge.low + edge.size > edge.room) return false;  // a kind that stands in no cell
  const int begin = edge.window_begin(least), end = edge.window_end(least);
  back.among(profile, begin, end, edge.place());
  const int by = forward.among(profile, begin, end) - edge.place();
  size = static_cast<int16_t>(size + (low_edge ? -by : by));
  if (low_edge && !in_grid) at = static_cast<int16_t>(at + by);
  if (low_edge)
    for (int line = 0; line < count; ++line)
      lines[static_cast<size_t>(line)] =
          static_cast<int16_t>(lines[static_cast<size_t>(line)] + by);
  state.changed(i), state.changed(above);
  return forward.possible() && shop.model.fits(state, i) && shop.model.fits(state, above);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(redraw) {
  return {{"redraw",
           "move",
           "Moves an edge of windows or a door to where the picture hints at one.",
           "",
           {}},
          3,
          redraw};
}
