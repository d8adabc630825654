// SPDX-License-Identifier: Apache-2.0
// Folds a grid with mirror symmetry into one half, or unfolds it.
#include <vug/fit/search/symmetry.h>

namespace vug::fit {
namespace {

bool symmetry(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  return fold_or_unfold(context, state, Op::mirror, forward, back);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(symmetry) {
  return {{"symmetry", "move", "Folds a symmetric grid into one half, or unfolds it.", "", {}},
          1,
          symmetry};
}
