// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/naming.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vug::fit {
namespace {

/// The production of an element to the first terminal of that type; -1 without one.
int find_production(const Rules& rules, int element, RegionType type) {
  for (const int id : rules.productions_of(element))
    if (rules.production(id).op == Op::terminal &&
        rules.symbol(rules.production(id).parts[0]).type == type)
      return id;
  return -1;
}

/// Replaces terminal i of an element by the first terminal of that type.
void rename(const Rules& rules, TreeState& state, int i, RegionType type) {
  const int above = i - 1, id = find_production(rules, state.tree[above].symbol, type);
  if (id < 0) return;
  state.tree[above].production = static_cast<int16_t>(id);
  state.tree[i].symbol = static_cast<int16_t>(rules.production(id).parts[0]);
  state.invalidate_bits(above), state.invalidate_bits(i);
}

/// The most frequent cluster.
std::ptrdiff_t main_of(const Sums& sums) {
  return std::max_element(sums.lane.begin(), sums.lane.end()) - sums.lane.begin();
}

/// Adds content to empty elements that do not look like wall; this costs no bits (see
/// Model::complexity).
void fill_elements(const Model& model, const Evidence& evidence, TreeState& state) {
  const Rules& rules = model.rules();
  const Likelihood& code = *model.likelihood();
  const auto plain = [&](int i) {
    return static_cast<Op>(state.tree[i].parent_op) == Op::elements && state.tree[i].production < 0;
  };
  Sums wall = evidence.sums(0, 0, evidence.width(), evidence.height());
  model.each_terminal(state, [&](RegionType, int, const Rect& r) {
    wall -= evidence.sums(r.x0, r.y0, r.x1, r.y1);
  });
  for (int i = 0; i < state.tree.size(); ++i)
    if (plain(i)) wall -= sum_of(evidence, state, state.area(i));
  for (int i = state.tree.size() - 1; i >= 0; --i) {
    if (!plain(i)) continue;
    const Sums own = sum_of(evidence, state, state.area(i));
    Sums together = wall;
    together += own;
    const auto bits = [&](const Sums& sums) { return code.bits(RegionType::wall, sums); };
    const int id = find_production(rules, state.tree[i].symbol, RegionType::window);
    if (id < 0 || state.tree.size() >= model.limits().max_nodes) continue;
    if (bits(together) <= bits(wall) + bits(own)) continue;
    Node node;
    node.symbol = static_cast<int16_t>(rules.production(id).parts[0]);
    node.parent_op = static_cast<int8_t>(Op::terminal);
    node.width = state.area(i).width, node.height = state.area(i).height;
    state.grow(i, id, {node});
    model.compute_areas(state);
  }
}

}  // namespace

void name_elements(const Model& model, const Evidence& evidence, TreeState& state) {
  const Likelihood* likelihood = model.likelihood();
  if (!likelihood) return;
  const bool supervised = likelihood->is_supervised();
  if (!supervised) fill_elements(model, evidence, state);
  const Rules& rules = model.rules();
  std::vector<Sums> of(state.tree.nodes.size());
  Sums windows;
  model.each_terminal(state, [&](RegionType, int node, const Rect& r) {
    const Sums sums = evidence.sums(r.x0, r.y0, r.x1, r.y1);
    of[static_cast<size_t>(node)] += sums;
    if (model.in_grid(state.tree[node])) windows += sums;
  });
  const bool any_windows = !(windows == Sums{});
  for (int i = 0; i < state.tree.size(); ++i) {
    const Node& node = state.tree[i];
    if (static_cast<Op>(node.parent_op) != Op::terminal) continue;
    if (supervised) {
      rename(rules, state, i, rules.symbol(node.symbol).type);
      continue;
    }
    const bool alike = any_windows && main_of(of[static_cast<size_t>(i)]) == main_of(windows);
    const bool grounded = node.y + node.height >= state.area(i).height - 1;
    const RegionType other = node.width > node.height ? RegionType::shop : RegionType::door;
    const bool admitted = grounded && model.admits(other, state.area(i), rect_of(node));
    rename(rules, state, i, alike || !admitted ? RegionType::window : other);
  }
}

}  // namespace vug::fit
