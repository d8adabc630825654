// Says that a grid's two halves are mirror images, or says them both.
#include <vug/fit/search/symmetry.h>

namespace vug::fit {
namespace {

bool symmetry(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  return fold_or_unfold(context, state, Op::mirror, forward, back);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(symmetry) {
  return {
      {"symmetry", "move", "Says once what is on both sides of an area, or says it twice.", "", {}},
      1,
      symmetry};
}
