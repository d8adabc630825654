// Says that a grid repeats a part of itself, or says it all.
#include <vug/fit/fold.h>

namespace vug::fit {
namespace {

bool repetition(const Workshop& shop, State& state, Choices& forward, Choices& back) {
  const int most = shop.model.limits().most_repeats;
  const auto plain = [&](int i) {
    return can_fold(shop, state, i) && folded_way(shop, state, i, Op::repeat) >= 0;
  };
  const auto folded = [&](int i) { return can_unfold(shop, state, i, Op::repeat); };
  const bool once = forward.flip();
  back.flip(!once);
  const int i = once ? pick(state, forward, plain) : pick(state, forward, folded);
  if (i < 0) return false;
  if (!once) {
    const Fold way{Op::repeat, state.tree[i + 1].extent};
    if (!unfold(shop, state, i, way, forward, back)) return false;
    tell_pick(state, back, i, plain);
    back.between(2, most, way.times);
    return true;
  }
  const Fold way{Op::repeat, forward.between(2, most)};
  Choices places;
  places.tell();
  if (!fold(shop, state, i, folded_way(shop, state, i, Op::repeat), way, forward, places))
    return false;
  tell_pick(state, back, i, folded);
  back.append(places);
  return true;
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
