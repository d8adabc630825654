// Says that a grid's two halves are mirror images, or says them both.
#include <vug/fit/fold.h>

namespace vug::fit {
namespace {

bool symmetry(const Workshop& shop, State& state, Choices& forward, Choices& back) {
  const auto plain = [&](int i) {
    return can_fold(shop, state, i) && folded_way(shop, state, i, Op::mirror) >= 0;
  };
  const auto folded = [&](int i) { return can_unfold(shop, state, i, Op::mirror); };
  const bool once = forward.flip();
  back.flip(!once);
  const int i = once ? pick(state, forward, plain) : pick(state, forward, folded);
  if (i < 0) return false;
  const Fold way{Op::mirror, 2};
  // What was folded has to be unfolded by the same choices: the node first, the places then.
  if (!once) {
    if (!unfold(shop, state, i, way, forward, back)) return false;
    tell_pick(state, back, i, plain);
    return true;
  }
  Choices places;
  places.tell();
  if (!fold(shop, state, i, folded_way(shop, state, i, Op::mirror), way, forward, places))
    return false;
  tell_pick(state, back, i, folded);
  back.append(places);
  return true;
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(symmetry) {
  return {
      {"symmetry", "move", "Says once what is on both sides of an area, or says it twice.", "", {}},
      1,
      symmetry};
}
