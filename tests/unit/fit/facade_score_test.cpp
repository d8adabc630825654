// SPDX-License-Identifier: Apache-2.0
// The score of facade trees equals that of the sampler's trees.
#include "random_walk.h"

#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/fit/facade_score.h>
#include <vug/fit/model/compile.h>
#include <vug/fit/report.h>
#include <vug/fit/to_facade.h>

#include <numeric>
#include <set>

namespace vug::fit {
namespace {

constexpr int kAcross = 212, kDown = 306;

const facade::Rules& rules_text() {
  static const facade::Rules all = facade::load_rules(VUG_DATA "/facades/ripperda.vug");
  return all;
}

ClusterImage clusters_of_noise() {
  ClusterImage out;
  out.width = kAcross, out.height = kDown, out.clusters = 3;
  RandomStream stream{RandomKey(11)};
  for (int i = 0; i < kAcross * kDown; ++i)
    out.labels.push_back(static_cast<uint8_t>(stream.below(3)));
  return out;
}

/// Whether each window kind of a grid has a size of its own and an instance, as in facade trees,
/// and whether all grids are divided.
bool has_distinct_kinds(const Rules& rules, const TreeState& state, const facade::Tree& tree) {
  if (tree.nodes.size() != static_cast<size_t>(state.tree.size())) return false;
  for (int i = 0; i < state.tree.size(); ++i) {
    if (rules.symbol(state.tree[i].symbol).grid && state.tree[i].production < 0) return false;
    std::set<std::pair<int, int>> sizes;
    int kinds = 0;
    for (int k = 0; k < state.tree.child_count(i); ++k) {
      const Node& part = state.tree[state.tree.child(i, k)];
      if (static_cast<Op>(part.parent_op) != Op::windows || part.parent_op < 0) continue;
      ++kinds, sizes.insert({part.width, part.height});
    }
    if (static_cast<int>(sizes.size()) != kinds) return false;
  }
  return true;
}

TEST(FacadeScore, EqualsTheScoreOfTheSampler) {
  const Rules rules = compile(rules_text());
  const ClusterImage clusters = clusters_of_noise();
  const Evidence evidence = clusters.evidence();
  const FacadeScorer scorer(rules_text(), clusters);
  const Model model(rules, {}, kAcross, kDown);
  const EdgeHints hints = EdgeHints::uniform(kAcross, kDown);
  const MoveContext context{model, hints};
  const inference::Moves<TreeState> all = moves(context);
  RandomStream stream{RandomKey(5)};
  TreeState here = model.axiom_state();
  model.energy(here);
  int compared = 0, exact = 0;
  for (int step = 0; step < 300'000; ++step) {
    if (!step_up(model, all, stream, here)) continue;
    if (here.tree.size() > 30) here = model.axiom_state();
    model.energy(here);
    if (step % 7 != 0) continue;
    const facade::Tree tree = to_facade_tree(rules_text(), model, here, {0.05, 0.06});
    if (!has_distinct_kinds(rules, here, tree)) continue;
    Report expected;
    add_score(expected, model, evidence, here.tree);
    const FacadeScore score = scorer.score(tree);
    EXPECT_DOUBLE_EQ(score.complexity, expected.complexity) << expected.structure;
    EXPECT_EQ(score.differing, std::accumulate(score.mask.begin(), score.mask.end(), size_t{0}));
    ++compared;
    // Widths of repeated parts are rounded to pixels, so that their copies are up to a pixel off.
    if (expected.structure.find("Repeated") != std::string::npos) continue;
    EXPECT_NEAR(score.misfit, expected.misfit, 1e-6 * expected.misfit) << expected.structure;
    EXPECT_NEAR(score.score, expected.score, 1e-9);
    ++exact;
  }
  EXPECT_GT(compared, 20);
  EXPECT_GT(exact, 10);
}

TEST(FacadeScore, RefusesTreesOutsideOfThePublishedSpace) {
  const FacadeScorer scorer(rules_text(), clusters_of_noise());
  facade::Tree other;
  other.width = 12, other.height = 9;
  EXPECT_THROW(scorer.score(other), Error);
}

}  // namespace
}  // namespace vug::fit
