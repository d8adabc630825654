// SPDX-License-Identifier: Apache-2.0
#include "random_walk.h"

#include <gtest/gtest.h>
#include <vug/facade/tree_output.h>
#include <vug/fit/model/compile.h>
#include <vug/fit/move.h>
#include <vug/fit/to_facade.h>

#include <cmath>
#include <set>
#include <tuple>

namespace vug::fit {
namespace {

using Instance = std::tuple<std::string, long, long, long, long>;

/// In pixels, row 0 being the top row.
Instance place_of(const std::string& name, double x, double y, double width, double height) {
  return {name, std::lround(x), std::lround(y), std::lround(width), std::lround(height)};
}

/// Compares the elements of the sampler's tree with those of the facade tree.
void expect_same_places(const facade::Rules& text, const Model& model, const TreeState& state) {
  const Vec2d kPixel(0.05, 0.06);
  const facade::Tree tree = to_facade_tree(text, model, state, kPixel);
  std::multiset<Instance> seen, stands;
  model.each_terminal(state, [&](RegionType, int node, const Rect& r) {
    seen.insert(place_of(model.rules().symbol(state.tree[node].symbol).name, r.x0, r.y0,
                         r.x1 - r.x0, r.y1 - r.y0));
  });
  for (const facade::ElementInstance& one : element_instances(tree))
    stands.insert(place_of(tree.nodes[static_cast<size_t>(one.node)].symbol, one.rect.x / kPixel.x,
                           model.height() - one.rect.top() / kPixel.y, one.rect.width / kPixel.x,
                           one.rect.height / kPixel.y));
  EXPECT_EQ(seen, stands) << theta(tree);
}

TEST(ToFacadeTree, PreservesThePositionsOfAllElements) {
  const facade::Rules text = facade::load_rules(VUG_DATA "/facades/ripperda.vug");
  const Rules rules = compile(text);
  const Model model(rules, {}, 211, 307);
  const EdgeHints hints = EdgeHints::uniform(211, 307);
  const MoveContext context{model, hints};
  const inference::Moves<TreeState> all = moves(context);
  RandomStream stream{RandomKey(5)};
  TreeState here = model.axiom_state();
  model.energy(here);
  int compared = 0;
  for (int step = 0; step < 20'000; ++step) {
    if (!step_up(model, all, stream, here)) continue;
    if (here.tree.size() > 30) here = model.axiom_state();
    model.energy(here);
    if (step % 50 == 0) expect_same_places(text, model, here), ++compared;
  }
  EXPECT_GT(compared, 20);
}

}  // namespace
}  // namespace vug::fit
