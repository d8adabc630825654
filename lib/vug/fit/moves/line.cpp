// SPDX-License-Identifier: Apache-2.0
// Moves one column or row of an irregular grid by a few pixels, or to a position that the picture
// hints at.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

bool line(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const Rules& rules = context.model.rules();
  Tree& tree = state.tree;
  const auto fits = [&](int i) {
    return is_grid(context, state, i) && !rules.symbol(tree[i].symbol).regular;
  };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool along_x = forward.flip();
  back.flip(along_x);
  Node& grid = tree[i];
  Lines& lines = along_x ? grid.left : grid.top;
  const int count = along_x ? grid.columns : grid.rows;
  const int which = forward.below(count);
  back.below(count, which);
  const auto at = static_cast<size_t>(which);
  const bool far = forward.flip();
  back.flip(far);
  if (far) {
    const Area& area = state.area(i);
    const inference::DiscreteDistribution& profile =
        along_x ? context.hints.left : context.hints.top;
    const int origin = along_x ? state.instance(area, 0).x : area.y;
    const int room = along_x ? area.width : area.height;
    const int low = origin + (which > 0 ? lines[at - 1] + 1 : 0);
    const int high = origin + (which + 1 < count ? lines[at + 1] : room);
    back.among(profile, low, high, origin + lines[at]);
    lines[at] = static_cast<int16_t>(forward.among(profile, low, high) - origin);
  } else {
    lines[at] = static_cast<int16_t>(lines[at] + step(forward, back));
  }
  state.invalidate_bits(i);
  return context.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(line) {
  return {{"line", "move", "Moves one column or row of an irregular grid.", "", {}}, 3, line};
}
