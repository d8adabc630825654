// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/polish/polish.h>

#include <algorithm>
#include <cmath>

namespace vug::fit {
namespace {

/// Shifts the contents of node i's area: a grid or free-standing elements.
void shift_content(TreeState& state, int i, int dx, int dy) {
  for (int part = i + 1; part < state.tree.end(i); ++part) {
    Node& node = state.tree[part];
    if (node.columns > 0) {
      shift_lines(node, true, dx), shift_lines(node, false, dy);
    } else if (static_cast<Op>(node.parent_op) == Op::terminal) {
      add(node.x, dx), add(node.y, dy);
    }
    state.invalidate_bits(part);
  }
  state.invalidate_bits(i);
}

/// Whether the node is split further, so that its contents cannot be shifted.
bool divided(const Rules& rules, const TreeState& state, int i) {
  const int id = state.tree[i].production;
  if (id < 0) return false;
  const Op op = rules.production(id).op;
  return op != Op::grid && op != Op::windows && op != Op::terminal;
}

class Polisher {
 public:
  Polisher(const MoveContext& context, const Evidence& evidence, TreeState& state)
      : context_(context), model_(context.model), evidence_(evidence), state_(state) {}

  bool sweep(Progress& progress) {
    bool better = false;
    for (int i = 0; i < state_.tree.size() && !progress.cancelled(); ++i) {
      const Rules& rules = model_.rules();
      if (state_.tree[i].extent > 0 && static_cast<Op>(state_.tree[i].parent_op) != Op::repeat)
        better |= extent(i);
      if (is_terminal(context_, state_, i) && !model_.in_grid(state_.tree[i])) better |= rect(i);
      if (state_.tree[i].production < 0) continue;
      if (try_prune(i) || try_hoist(i)) {
        better = true;
        continue;
      }
      if (rules.production(state_.tree[i].production).op == Op::grid) {
        better |= polish_type(context_, state_, i);
        better |= polish_grid(context_, evidence_, state_, i);
        better |= polish_cells(context_, evidence_, state_, i);
        better |= polish_kinds(context_, evidence_, state_, i);
      }
    }
    return better;
  }

 private:
  /// Exhaustive search over the values that `change(state, by)` changes.
  template <class Change>
  bool search(int low, int high, const Change& change) {
    TreeState best = state_;
    bool better = false;
    for (int by = low; by <= high; ++by) {
      if (by == 0) continue;
      TreeState other = state_;
      if (change(other, by)) better |= replace_if_cheaper(model_, best, std::move(other));
    }
    if (better) state_ = std::move(best);
    return better;
  }

  /// Removes the node's descendants if that is cheaper.
  bool try_prune(int i) {
    TreeState other = state_;
    other.prune(i);
    other.invalidate_areas();
    return replace_if_cheaper(model_, state_, std::move(other));
  }

  /// Moves a grid that is the only content of one of the node's children up to the node, if that is
  /// cheaper.
  bool try_hoist(int i) {
    const Tree& tree = state_.tree;
    int full = -1;
    for (int part = i + 1; part < tree.end(i); part = tree.end(part)) {
      if (tree[part].production < 0) continue;
      if (full >= 0) return false;
      full = part;
    }
    const Rules& rules = model_.rules();
    if (full < 0 || rules.production(tree[full].production).op != Op::grid) return false;
    const Area &area = state_.area(i), &inner = state_.area(full);
    if (inner.count != area.count) return false;
    for (const int id : rules.productions_of(tree[i].symbol)) {
      const Production& production = rules.production(id);
      if (production.op != Op::grid || production.parts[0] != tree[full + 1].symbol) continue;
      std::vector<Node> nodes(tree.nodes.begin() + full, tree.nodes.begin() + tree.end(full));
      const int16_t size = nodes[0].size;
      nodes[0] = tree[i];
      nodes[0].size = size, nodes[0].production = static_cast<int16_t>(id);
      TreeState other = state_;
      other.replace(i, nodes);
      other.invalidate_areas();
      shift_content(other, i, state_.instance(inner, 0).x - state_.instance(area, 0).x,
                    inner.y - area.y);
      return replace_if_cheaper(model_, state_, std::move(other));
    }
    return false;
  }

  /// Searches the edges and the position of a free-standing element.
  bool rect(int i) {
    bool better = false;
    for (const bool along_x : {true, false}) {
      const Area& area = state_.area(i);
      const int room = along_x ? area.width : area.height;
      for (const bool low : {true, false})
        better |= search(-room, room, [&](TreeState& other, int by) {
          return move_edge(context_, other, i, along_x, low, by);
        });
      better |= search(-room, room, [&](TreeState& other, int by) {
        Node& node = other.tree[i];
        add(along_x ? node.x : node.y, by);
        other.invalidate_bits(other.tree.parent(i));
        other.invalidate_bits(i);
        return model_.fits(other, i);
      });
    }
    return better;
  }

  /// Searches the line between this child and the next, with their contents staying in place or
  /// moving along.
  bool extent(int i) {
    const Op op = static_cast<Op>(state_.tree[i].parent_op);
    const int above = state_.tree.parent(i), next = state_.tree.end(i);
    const int room = op == Op::rows ? state_.area(above).height : state_.area(above).width;
    bool better = false;
    for (const bool stays : {true, false})
      better |= search(-room, room, [&](TreeState& other, int by) {
        Tree& tree = other.tree;
        if (op == Op::mirror && by % 2 != 0) return false;
        add(tree[i].extent, by);
        if (op == Op::elements && tree[next].extent > 0) add(tree[next].extent, -by);
        if (tree[i].extent <= 0 || (op == Op::elements && tree[next].extent < 0)) return false;
        const Rules& rules = model_.rules();
        // Areas start at the upper left: the row, the middle and the next element move.
        const int moved = op == Op::elements ? next : i;
        if (stays && divided(rules, other, moved)) return false;
        if (stays)
          shift_content(other, moved,
                        op == Op::rows     ? 0
                        : op == Op::mirror ? by / 2
                                           : -by,
                        op == Op::rows ? by : 0);
        other.invalidate_bits(i);
        if (op == Op::elements) other.invalidate_bits(next);
        other.invalidate_areas();
        return true;
      });
    return better;
  }

  const MoveContext& context_;
  const Model& model_;
  const Evidence& evidence_;
  TreeState& state_;
};

}  // namespace

bool replace_if_cheaper(const Model& model, TreeState& state, TreeState other) {
  constexpr double kTiny = 1e-9;
  if (!(model.energy(other) < model.energy(state) - kTiny)) return false;
  state = std::move(other);
  return true;
}

PolishResult polish(const MoveContext& context, const Evidence& evidence, TreeState& state,
                    Progress& progress) {
  constexpr int kMaxRounds = 20;
  PolishResult out;
  out.before = context.model.energy(state);
  Polisher polisher(context, evidence, state);
  bool better = true;
  while (better && out.rounds < kMaxRounds && !progress.cancelled()) {
    better = polisher.sweep(progress);
    ++out.rounds;
  }
  out.after = context.model.energy(state);
  return out;
}

}  // namespace vug::fit
