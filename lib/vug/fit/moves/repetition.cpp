// SPDX-License-Identifier: Apache-2.0
// Folds a grid that repeats a part of itself into a repetition, or unfolds it.
#include <vug/fit/search/symmetry.h>

namespace vug::fit {
namespace {

bool repetition(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  return fold_or_unfold(context, state, Op::repeat, forward, back);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(repetition) {
  return {{"repetition",
           "move",
           "Folds a repeating grid into one repeated part, or unfolds it.",
           "",
           {}},
          1,
          repetition};
}
