#include <vug/fit/naming.h>

#include <vector>

namespace vug::fit {
namespace {

/// The production of an element to the first thing that looks so; -1.
int way_to(const Rules& rules, int element, Look look) {
  for (const int way : rules.productions_of(element))
    if (rules.production(way).op == Op::terminal &&
        rules.symbol(rules.production(way).parts[0]).look == look)
      return way;
  return -1;
}

}  // namespace

void name_elements(const Model& model, const Evidence& evidence, State& state) {
  const Likelihood* likelihood = model.likelihood();
  if (!likelihood || likelihood->of_looks()) return;
  const Rules& rules = model.rules();
  std::vector<Sums> of(state.tree.nodes.size());
  Sums windows;
  model.each_terminal(state, [&](Look, int node, const Rect& r) {
    const Sums sums = evidence.sums(r.x0, r.y0, r.x1, r.y1);
    of[static_cast<size_t>(node)] += sums;
    if (model.in_grid(state.tree[node])) windows += sums;
  });
  const auto bits = [&](const Sums& sums) { return likelihood->bits(Look::window, sums); };
  for (int i = 0; i < state.tree.size(); ++i) {
    const Node& node = state.tree[i];
    if (static_cast<Op>(node.made_by) != Op::terminal) continue;
    const Sums& own = of[static_cast<size_t>(i)];
    Sums together = windows;
    together += own;
    const bool alike = bits(together) < bits(windows) + bits(own);
    const bool grounded = node.y + node.height >= state.area(i).height - 1;
    const Look other = node.width > node.height ? Look::shop : Look::door;
    const int above = i - 1;
    const int way =
        way_to(rules, state.tree[above].symbol, alike || !grounded ? Look::window : other);
    if (way < 0) continue;
    state.tree[above].production = static_cast<int16_t>(way);
    state.tree[i].symbol = static_cast<int16_t>(rules.production(way).parts[0]);
    state.changed(above), state.changed(i);
  }
}

}  // namespace vug::fit
