// Says that a grid repeats a part of itself, or says it all.
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
           "Says once what a grid repeats, or says it as often as it is there.",
           "",
           {}},
          1,
          repetition};
}
