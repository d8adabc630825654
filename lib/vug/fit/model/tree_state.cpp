#include <vug/fit/model/tree_state.h>

namespace vug::fit {
namespace {

/// Makes room for `count` nodes of which nothing is known, before place `at`.
void open(State& state, int at, int count) {
  const auto n = static_cast<size_t>(count);
  state.areas.insert(state.areas.begin() + at, n, Area{});
  state.bits.insert(state.bits.begin() + at, n, 0);
  state.known.insert(state.known.begin() + at, n, 0);
  state.moved();
}

void close(State& state, int at, int count) {
  state.areas.erase(state.areas.begin() + at, state.areas.begin() + at + count);
  state.bits.erase(state.bits.begin() + at, state.bits.begin() + at + count);
  state.known.erase(state.known.begin() + at, state.known.begin() + at + count);
  state.moved();
}

}  // namespace

void State::grow(int i, int production, const std::vector<Node>& parts) {
  tree.grow(i, production, parts);
  open(*this, i + 1, static_cast<int>(parts.size()));
  changed(i);
}

void State::prune(int i) {
  close(*this, i + 1, tree[i].size - 1);
  tree.prune(i);
  changed(i);
}

void State::insert(int i, int at, const Node& node) {
  tree.insert(i, at, node);
  open(*this, at, 1);
  changed(i);
}

void State::erase(int i, int at) {
  close(*this, at, tree[at].size);
  tree.erase(i, at);
  changed(i);
}

void State::replace(int i, const std::vector<Node>& nodes) {
  const int before = tree[i].size, count = static_cast<int>(nodes.size());
  close(*this, i, before);
  open(*this, i, count);
  tree.replace(i, nodes);
}

}  // namespace vug::fit
