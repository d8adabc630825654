// SPDX-License-Identifier: Apache-2.0
// The sampler visits states with the right frequencies: tested over all trees of small grammars,
// with all moves together and with each alone.
#include "enumeration.h"

#include <vug/fit/move.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::fit {
namespace {

using inference::Chain;

struct Toy {
  std::string name;
  std::vector<std::string> rules;
  int width, height;
  Limits limits;
  std::vector<std::string> moves;  ///< Moves that apply to this grammar.
};

Limits tiny(int lines, int elements = 2) {
  Limits limits;
  limits.min_size = 1;
  limits.max_lines = lines;
  limits.max_elements = elements;
  limits.max_repeats = 3;
  limits.max_kinds = 2;
  return limits;
}

std::vector<Toy> toys() {
  return {
      {"grids",
       {"Facade grid RegularIdenticalGrid", "RegularIdenticalGrid windows Window"},
       4,
       2,
       tiny(2),
       {"rewrite", "whole_grid", "shift", "resize", "pitch", "lines", "redraw"}},
      {"types",
       {"Facade grid RegularIdenticalGrid", "Facade grid IdenticalGrid",
        "RegularIdenticalGrid windows Window", "IdenticalGrid windows Window"},
       5,
       1,
       tiny(3),
       {"rewrite", "whole_grid", "grid_type", "shift", "resize", "pitch", "line", "lines",
        "split_lines", "redraw"}},
      {"kinds",
       {"Facade grid RegularGrid", "Facade grid RegularIdenticalGrid",
        "RegularIdenticalGrid windows Window", "RegularGrid windows Window"},
       3,
       1,
       tiny(2),
       {"rewrite", "grid_type", "differ", "cell", "kinds", "shift", "resize", "lines", "redraw"}},
      {"elements",
       {"Facade elements Element", "Element terminal Window", "Element terminal Door"},
       3,
       1,
       tiny(2),
       {"rewrite", "elements", "terminal", "divide", "shift", "resize", "redraw"}},
      {"rows",
       {"Facade rows Row Part", "Part grid RegularIdenticalGrid", "Row elements Element"},
       3,
       3,
       tiny(2),
       {"rewrite", "elements", "divide", "shift", "lines"}},
      {"symmetry",
       {"Facade mirror Side", "Facade mirror Side Middle", "Facade grid IdenticalGrid",
        "Side grid IdenticalGrid", "IdenticalGrid windows Window"},
       6,
       1,
       tiny(2),
       {"rewrite", "whole_grid", "symmetry", "divide", "line", "lines", "shift", "resize",
        "redraw"}},
      {"repetition",
       {"Facade repeat Part", "Facade grid IdenticalGrid", "Part grid IdenticalGrid",
        "IdenticalGrid windows Window"},
       7,
       1,
       tiny(4),
       {"rewrite", "whole_grid", "repetition", "repetitions", "line", "lines", "shift", "resize",
        "redraw"}},
      {"door",
       {"Facade grid RegularIdenticalGrid", "RegularIdenticalGrid windows Window",
        "RegularIdenticalGrid windows Window Door"},
       3,
       1,
       tiny(1),
       {"rewrite", "whole_grid", "door", "shift", "resize", "redraw"}},
  };
}

/// The exact probability of every tree, from its energy.
std::map<std::string, double> exact(const Model& model, double temperature) {
  std::map<std::string, double> out;
  double sum = 0;
  Enumeration(model, [&](const Tree& tree) {
    TreeState state = model.make_state(tree);
    const double p = std::exp2(-model.energy(state) / temperature);
    const auto [at, fresh] = out.emplace(name_of(tree), p);
    EXPECT_TRUE(fresh) << "the enumeration contains a tree twice";
    sum += p;
  }).run();
  for (auto& [name, p] : out) p /= sum;
  return out;
}

double total_variation(const std::map<std::string, double>& probabilities,
                       const std::map<std::string, int64_t>& counts, int64_t all) {
  double sum = 0;
  for (const auto& [name, p] : probabilities) {
    const auto found = counts.find(name);
    const double share = found == counts.end() ? 0 : static_cast<double>(found->second);
    sum += std::fabs(share / static_cast<double>(all) - p);
  }
  for (const auto& [name, count] : counts)
    if (!probabilities.count(name)) sum += static_cast<double>(count) / static_cast<double>(all);
  return sum / 2;
}

/// The name is only computed when the state changes.
std::map<std::string, int64_t> visits(Chain<TreeState>& chain, int64_t steps) {
  std::map<std::string, int64_t> counts;
  Tree last = chain.state().tree;
  int64_t stay = 0;
  for (int64_t i = 0; i < steps; ++i) {
    chain.step();
    if (!(chain.state().tree == last)) {
      counts[name_of(last)] += stay;
      last = chain.state().tree;
      stay = 0;
    }
    ++stay;
  }
  counts[name_of(last)] += stay;
  return counts;
}

std::vector<uint8_t> picture(int width, int height) {
  std::vector<uint8_t> out;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) out.push_back(static_cast<uint8_t>((x + y / 2) % 2));
  return out;
}

// Hot enough that all trees are visited.
constexpr double kTemperature = 12;

/// A toy grammar with everything its chain refers to.
struct Bench {
  explicit Bench(const Toy& toy)
      : rules(rules_of(toy.rules)),
        evidence(Evidence::from_clusters(toy.width, toy.height, 2, picture(toy.width, toy.height))),
        model(rules, toy.limits, toy.width, toy.height,
              {&evidence, make_likelihood("kt", evidence)}),
        prior(rules, toy.limits, toy.width, toy.height),
        hints(EdgeHints::uniform(toy.width, toy.height)) {}
  Chain<TreeState>::Energy energy(const Model& of) const {
    return [&of](TreeState& state) { return of.energy(state); };
  }
  const Rules rules;
  const Evidence evidence;
  const Model model, prior;
  const EdgeHints hints;
  const MoveContext context{model, hints};
};

double distance(const Toy& toy, int64_t steps, Chain<TreeState>::Options options) {
  const Bench bench(toy);
  const inference::Moves<TreeState> some = moves(bench.context, toy.moves);
  EXPECT_EQ(some.size(), toy.moves.size());
  options.temperature = kTemperature;
  Chain<TreeState> chain(some, bench.energy(bench.model), bench.model.axiom_state(), RandomKey(3),
                         options);
  return total_variation(exact(bench.model, kTemperature), visits(chain, steps), steps);
}

TEST(FacadeChain, TreesHaveTheirExactFrequencies) {
  for (const Toy& toy : toys()) EXPECT_LT(distance(toy, 1'000'000, {}), 0.03) << toy.name;
}

TEST(FacadeChain, MoreStepsConverge) { EXPECT_LT(distance(toys().front(), 10'000'000, {}), 0.006); }

TEST(FacadeChain, WithoutTheProposalRatioFrequenciesAreWrong) {
  for (const Toy& toy : toys())
    EXPECT_GT(distance(toy, 100'000, {.use_proposal_ratio = false}), 0.3) << toy.name;
}

/// A random tree from which the move is possible.
TreeState start_for(const Bench& bench, const inference::Move<TreeState>& move,
                    const std::vector<Tree>& trees, RandomStream& stream) {
  Choices forward, back;
  for (int tries = 0; tries < 100'000; ++tries) {
    TreeState state =
        bench.prior.make_state(trees[stream.below(static_cast<uint32_t>(trees.size()))]);
    bench.prior.energy(state);
    TreeState next = state;
    forward.draw(stream);
    back.score();
    if (move.propose(next, forward, back) && std::isfinite(bench.prior.energy(next)) &&
        !(next.tree == state.tree))
      return state;
  }
  ADD_FAILURE() << move.name << " is not possible from any tree";
  return bench.prior.axiom_state();
}

/// Started from a tree where it is possible, each move alone preserves the prior of the trees it
/// reaches.
TEST(FacadeChain, EachMoveAlonePreservesThePrior) {
  std::map<std::string, int> reached;
  for (const Toy& toy : toys()) {
    const Bench bench(toy);
    std::vector<Tree> trees;
    Enumeration(bench.prior, [&](const Tree& tree) { trees.push_back(tree); }).run();
    const auto truth = exact(bench.prior, kTemperature);
    RandomStream stream{RandomKey(8)};
    for (const std::string& name : toy.moves) {
      const inference::Moves<TreeState> one = moves(bench.context, {name});
      size_t most = 0;
      for (int start = 0; start < 2; ++start) {
        TreeState state = start_for(bench, one.front(), trees, stream);
        Chain<TreeState> chain(one, bench.energy(bench.prior), state,
                               RandomKey(static_cast<uint64_t>(start)),
                               {.temperature = kTemperature});
        constexpr int64_t kSteps = 200'000;
        const auto counts = visits(chain, kSteps);
        std::map<std::string, double> among;
        double sum = 0;
        for (const auto& [visited, count] : counts) sum += among[visited] = truth.at(visited);
        for (auto& [visited, p] : among) p /= sum;
        most = std::max(most, among.size());
        EXPECT_LT(total_variation(among, counts, kSteps), 0.1)
            << toy.name << ": " << name << " among " << among.size();
      }
      reached[name] = std::max(reached[name], static_cast<int>(most));
    }
  }
  for (const MoveKind* kind : move_kinds())
    EXPECT_GT(reached[kind->info.name], 1) << kind->info.name << " was never made";
}

}  // namespace
}  // namespace vug::fit
