// SPDX-License-Identifier: Apache-2.0
// Splits the windows of one kind in a column or row off as a new kind, or merges the last kind with
// another one.
#include <vug/fit/model/cells.h>

namespace vug::fit {
namespace {

constexpr int kMaxStep = 12;  // Maximum difference of sizes in pixels.

/// Whether the kind occurs in cells of that line only.
bool occurs_only_in(const GridAxis& axis, int line, int kind) {
  bool there = false;
  for (int at = 0; at < axis.count; ++at)
    for (int other = 0; other < axis.across(); ++other) {
      if (axis.kind(at, other) != kind) continue;
      if (at != line) return false;
      there = true;
    }
  return there;
}

bool occurs_in(const GridAxis& axis, int line, int kind) {
  for (int other = 0; other < axis.across(); ++other)
    if (axis.kind(line, other) == kind) return true;
  return false;
}

void replace(GridAxis& axis, int line, int kind, int by) {
  for (int other = 0; other < axis.across(); ++other)
    if (axis.kind(line, other) == kind) axis.set_kind(line, other, by);
}

bool differ(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const auto fits = [&](int i) { return has_cells(context, state, i); };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool split = forward.flip(), along_x = forward.flip();
  back.flip(!split), back.flip(along_x);
  GridAxis axis(context, state, i, along_x);
  const int line = forward.below(axis.count);
  back.below(axis.count, line);
  state.invalidate_bits(i);
  if (split) {
    if (axis.kinds >= context.model.limits().max_kinds) return false;
    const int kind = 1 + forward.below(axis.kinds), fresh = axis.kinds + 1;
    back.below(axis.kinds, kind - 1);
    if (!occurs_in(axis, line, kind)) return false;
    replace(axis, line, kind, fresh);
    Node window = state.tree[i + kind];
    const int wider = forward.between(-kMaxStep, kMaxStep);
    const int higher = forward.between(-kMaxStep, kMaxStep);
    window.width = static_cast<int16_t>(window.width + wider);
    window.height = static_cast<int16_t>(window.height + higher);
    state.insert(i, i + fresh, window);
    return context.model.fits(state, i);
  }
  if (axis.kinds < 2) return false;
  const int last = axis.kinds, kind = 1 + forward.below(axis.kinds - 1);
  if (!occurs_only_in(axis, line, last) || occurs_in(axis, line, kind)) return false;
  replace(axis, line, last, kind);
  back.below(axis.kinds - 1, kind - 1);
  back.between(-kMaxStep, kMaxStep, state.tree[i + last].width - state.tree[i + kind].width);
  back.between(-kMaxStep, kMaxStep, state.tree[i + last].height - state.tree[i + kind].height);
  state.erase(i, i + last);
  return true;
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(differ) {
  return {{"differ",
           "move",
           "Splits off a new window kind for a column or row, or merges two kinds.",
           "",
           {}},
          2,
          differ};
}
