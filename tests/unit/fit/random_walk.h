// SPDX-License-Identifier: Apache-2.0
// Random walks through the trees of a model, for tests that need large trees.
#pragma once

#include <vug/fit/move.h>

#include <cmath>

namespace vug::fit {

/// Tries one of the moves; moves that shrink the tree are accepted less often. Returns whether
/// `here`, whose energy is valid, has changed.
inline bool step_up(const Model& model, const inference::Moves<TreeState>& moves,
                    RandomStream& stream, TreeState& here) {
  TreeState next = here;
  Choices forward, back;
  forward.draw(stream);
  back.score();
  const inference::Move<TreeState>& move = moves[stream.below(static_cast<uint32_t>(moves.size()))];
  if (!move.propose(next, forward, back) || !std::isfinite(model.energy(next))) return false;
  if (next.tree.size() < here.tree.size() && !(stream.uniform() < 0.3)) return false;
  here = std::move(next);
  return true;
}

}  // namespace vug::fit
