// SPDX-License-Identifier: Apache-2.0
// Every move is reversible by the choices it scores, with the probabilities it reports, bit for
// bit.
#include "enumeration.h"
#include "random_walk.h"

#include <vug/fit/search/sampler.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::fit {
namespace {

using inference::Chain;

/// All operations in a few productions.
Rules all_rules() {
  return rules_of({"Facade rows Row Part",
                   "Facade mirror Side",
                   "Facade mirror Side Middle",
                   "Facade repeat Part",
                   "Facade grid IdenticalGrid",
                   "Facade grid RegularIdenticalGrid",
                   "Part repeat Side",
                   "Part grid Grid",
                   "Part grid RegularGrid",
                   "Part grid IdenticalGrid",
                   "Part grid RegularIdenticalGrid",
                   "Part mirror Side",
                   "Side grid Grid",
                   "Side grid RegularGrid",
                   "Side grid RegularIdenticalGrid",
                   "Side grid IdenticalGrid",
                   "Middle grid RegularGrid",
                   "Row elements Element",
                   "Row grid RegularIdenticalGrid",
                   "Element terminal Window",
                   "Element terminal Door",
                   "Element terminal Shop",
                   "Grid windows Window",
                   "Grid windows Window Door",
                   "RegularGrid windows Window",
                   "RegularGrid windows Window Door",
                   "IdenticalGrid windows Window",
                   "IdenticalGrid windows Window Door",
                   "RegularIdenticalGrid windows Window",
                   "RegularIdenticalGrid windows Window Door"});
}

inference::DiscreteDistribution lumpy(int size, uint64_t seed) {
  RandomStream stream{RandomKey(seed)};
  std::vector<double> weights;
  for (int i = 0; i < size; ++i) weights.push_back(0.1 + stream.uniform());
  return inference::DiscreteDistribution(weights);
}

EdgeHints lumpy_hints(int width, int height) {
  return {lumpy(width + 1, 1), lumpy(width + 1, 2), lumpy(height + 1, 3), lumpy(height + 1, 4),
          lumpy(height + 1, 5)};
}

std::vector<uint8_t> noise(int count, int clusters) {
  RandomStream stream{RandomKey(9)};
  std::vector<uint8_t> out;
  for (int i = 0; i < count; ++i)
    out.push_back(static_cast<uint8_t>(stream.below(static_cast<uint32_t>(clusters))));
  return out;
}

/// A grid of windows in a part that is mirrored or repeated.
TreeState folded(const Model& model, Op op) {
  const Rules& rules = model.rules();
  TreeState state = model.axiom_state();
  const auto find_production = [&](int i, Op wanted, const std::string& part) {
    for (const int at : rules.productions_of(state.tree[i].symbol))
      if (rules.production(at).op == wanted && rules.production(at).parts.size() == 1 &&
          rules.symbol(rules.production(at).parts[0]).name == part)
        return at;
    return -1;
  };
  const auto grow = [&](int i, int production, Node node) {
    node.symbol = static_cast<int16_t>(rules.production(production).parts[0]);
    node.parent_op = static_cast<int8_t>(rules.production(production).op);
    state.grow(i, production, {node});
  };
  Node part, grid, window;
  part.extent = op == Op::repeat ? 3 : 0;
  grid.columns = 2, grid.rows = 1, grid.left = {3, 11}, grid.top = {5};
  window.width = 6, window.height = 9;
  grow(0, find_production(0, op, op == Op::repeat ? "Part" : "Side"), part);
  grow(1, find_production(1, Op::grid, "IdenticalGrid"), grid);
  grow(2, find_production(2, Op::windows, "Window"), window);
  EXPECT_TRUE(std::isfinite(model.energy(state)));
  return state;
}

TEST(Moves, AreReversedByTheChoicesTheyScore) {
  constexpr int kWidth = 61, kHeight = 47;
  const Rules rules = all_rules();
  Limits limits;
  limits.min_size = 2;
  limits.max_kinds = 3;
  const Model model(rules, limits, kWidth, kHeight);
  const EdgeHints hints = lumpy_hints(kWidth, kHeight);
  const MoveContext context{model, hints};
  const inference::Moves<TreeState> all = moves(context);
  ASSERT_EQ(all.size(), move_kinds().size());
  RandomStream stream{RandomKey(2)};
  Choices forward, back, again, returned;
  std::map<std::string, int> done;
  TreeState here = model.axiom_state();
  model.energy(here);
  for (int count = 0, tries = 0; count < 100'000; ++tries) {
    ASSERT_LT(tries, 1'000'000);
    const inference::Move<TreeState>& move = all[stream.below(static_cast<uint32_t>(all.size()))];
    TreeState state = here;
    forward.draw(stream);
    back.score();
    if (!move.propose(state, forward, back) || !std::isfinite(model.energy(state))) continue;
    ++count, ++done[move.name];
    ASSERT_TRUE(forward.possible()) << move.name;
    ASSERT_TRUE(back.possible()) << move.name;
    TreeState there = state;
    again.replay(back.trace());
    returned.score();
    ASSERT_TRUE(move.propose(there, again, returned)) << move.name;
    ASSERT_EQ(again.trace().size(), back.trace().size()) << move.name;
    ASSERT_TRUE(there.tree == here.tree) << move.name;
    ASSERT_NEAR(again.ln_probability(), back.ln_probability(), 1e-12) << move.name;
    ASSERT_NEAR(returned.ln_probability(), forward.ln_probability(), 1e-12) << move.name;
    ASSERT_NEAR(inference::ln_ratio(forward, back) + inference::ln_ratio(again, returned), 0,
                1e-12);
    // A walk with a preference for growth, so that large trees occur too.
    if (state.tree.size() >= here.tree.size() || stream.uniform() < 0.3) here = state;
    if (here.tree.size() > 30 || tries % 500 == 0) {
      here = tries % 1500 == 0   ? folded(model, Op::mirror)
             : tries % 1000 == 0 ? folded(model, Op::repeat)
                                 : model.axiom_state();
      model.energy(here);
    }
  }
  for (const MoveKind* kind : move_kinds())
    EXPECT_GT(done[kind->info.name], 20) << kind->info.name << " was hardly tried";
}

TEST(Moves, CachedValuesAreAlwaysValid) {
  constexpr int kWidth = 64, kHeight = 48;
  const Rules rules = all_rules();
  Limits limits;
  limits.min_size = 2;
  const Evidence evidence = Evidence::from_clusters(kWidth, kHeight, 3, noise(kWidth * kHeight, 3));
  const Model model(rules, limits, kWidth, kHeight, {&evidence, make_likelihood("kt", evidence)});
  const EdgeHints hints = lumpy_hints(kWidth, kHeight);
  const MoveContext context{model, hints};
  const inference::Moves<TreeState> all = moves(context);
  // Compares cached and recomputed energies of every proposal, including rejected ones.
  int64_t scored = 0, wrong = 0;
  const auto energy = [&](TreeState& state) {
    const double kept = model.energy(state);
    TreeState fresh = model.make_state(state.tree);
    const double full = model.energy(fresh);
    ++scored;
    if (!(kept == full || std::fabs(kept - full) <= 1e-9)) ++wrong;
    return kept;
  };
  Chain<TreeState> chain(all, energy, model.axiom_state(), RandomKey(4), {.temperature = 1000});
  while (scored < 1'000'000) {
    chain.step();
    if (scored % 1000 != 0) continue;
    TreeState fresh = model.make_state(chain.state().tree);
    ASSERT_NEAR(model.energy(fresh), chain.energy(), 1e-9) << "after a rejection too";
  }
  EXPECT_EQ(wrong, 0) << "of " << scored;
}

/// The region index of every pixel; -1 for none.
std::vector<int> regions_of(const Model& model, const TreeState& state) {
  std::vector<int> out(static_cast<size_t>(model.width() * model.height()), -1);
  const Rules& rules = model.rules();
  const Tree& tree = state.tree;
  const auto paint = [&](const Rect& r, int region) {
    for (int y = r.y0; y < r.y1; ++y)
      for (int x = r.x0; x < r.x1; ++x) out[static_cast<size_t>(y * model.width() + x)] = region;
  };
  // Parents come first, so that children overwrite their remainder.
  for (int i = 0; i < tree.size(); ++i) {
    if (rules.symbol(tree[i].symbol).terminal) continue;
    const Area& area = state.area(i);
    for (int place = 0; place < area.count; ++place)
      paint(Model::in_picture(area, state.instance(area, place), 0, 0, area.width, area.height), i);
  }
  model.each_terminal(state, [&](RegionType type, int node, const Rect& r) {
    // Windows of a grid are one region, regardless of their kind.
    paint(r,
          1000 + (type == RegionType::window && model.in_grid(tree[node]) ? tree.parent(node) * 1000
                                                                          : node));
  });
  return out;
}

TEST(Model, BitsMatchPixelByPixelCounts) {
  constexpr int kWidth = 57, kHeight = 43, kClusters = 3;
  const Rules rules = all_rules();
  Limits limits;
  limits.min_size = 2;
  const std::vector<uint8_t> clusters = noise(kWidth * kHeight, kClusters);
  const Evidence evidence = Evidence::from_clusters(kWidth, kHeight, kClusters, clusters);
  const LikelihoodPtr likelihood = make_likelihood("kt", evidence);
  const Model model(rules, limits, kWidth, kHeight, {&evidence, likelihood, 0.7});
  const EdgeHints hints = lumpy_hints(kWidth, kHeight);
  const MoveContext context{model, hints};
  const inference::Moves<TreeState> all = moves(context);
  RandomStream stream{RandomKey(6)};
  TreeState here = model.axiom_state();
  model.energy(here);
  int large = 0;
  for (int trees = 0; trees < 1000; ++trees) {
    if (here.tree.size() > 25) here = model.axiom_state();
    for (int i = 0; i < 30; ++i) step_up(model, all, stream, here);
    TreeState fresh = model.make_state(here.tree);
    ASSERT_NEAR(model.energy(fresh), model.energy(here), 1e-9) << structure_of(rules, here.tree);
    large += here.tree.size() > 5 ? 1 : 0;
    const std::vector<int> regions = regions_of(model, here);
    std::map<int, Sums> counts;
    for (size_t i = 0; i < regions.size(); ++i) ++counts[regions[i]].lane[clusters[i]];
    double bits = 0;
    for (const auto& [region, sums] : counts) bits += likelihood->bits(RegionType::wall, sums);
    ASSERT_NEAR(model.complexity(here.tree) + 0.7 * bits, model.energy(here), 1e-6)
        << structure_of(rules, here.tree);
  }
  EXPECT_GT(large, 300);
}

}  // namespace
}  // namespace vug::fit
