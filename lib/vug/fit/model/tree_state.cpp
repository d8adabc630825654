// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/model/tree_state.h>

namespace vug::fit {
namespace {

/// Inserts invalid cache entries for `count` nodes before index `at`.
void open(TreeState& state, int at, int count) {
  const auto n = static_cast<size_t>(count);
  state.areas.insert(state.areas.begin() + at, n, Area{});
  state.bits.insert(state.bits.begin() + at, n, 0);
  state.bits_valid.insert(state.bits_valid.begin() + at, n, 0);
  state.invalidate_areas();
}

void close(TreeState& state, int at, int count) {
  state.areas.erase(state.areas.begin() + at, state.areas.begin() + at + count);
  state.bits.erase(state.bits.begin() + at, state.bits.begin() + at + count);
  state.bits_valid.erase(state.bits_valid.begin() + at, state.bits_valid.begin() + at + count);
  state.invalidate_areas();
}

}  // namespace

void TreeState::grow(int i, int production, const std::vector<Node>& parts) {
  tree.grow(i, production, parts);
  open(*this, i + 1, static_cast<int>(parts.size()));
  invalidate_bits(i);
}

void TreeState::prune(int i) {
  close(*this, i + 1, tree[i].size - 1);
  tree.prune(i);
  invalidate_bits(i);
}

void TreeState::insert(int i, int at, const Node& node) {
  tree.insert(i, at, node);
  open(*this, at, 1);
  invalidate_bits(i);
}

void TreeState::erase(int i, int at) {
  close(*this, at, tree[at].size);
  tree.erase(i, at);
  invalidate_bits(i);
}

void TreeState::replace(int i, const std::vector<Node>& nodes) {
  const int before = tree[i].size, count = static_cast<int>(nodes.size());
  close(*this, i, before);
  open(*this, i, count);
  tree.replace(i, nodes);
}

}  // namespace vug::fit
