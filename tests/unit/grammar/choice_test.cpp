// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/grammar/tree_output.h>

#include <gtest/gtest.h>

#include <map>

namespace vug::grammar {
namespace {

Grammar weighted(int64_t count) {
  Grammar g;
  g.axiom = {part("A", count)};
  g.productions = {rule("A", {terminal("a")}, 3), rule("A", {terminal("b")}, 1),
                   rule("A", {terminal("never")}, 0), rule("A", {terminal("c")}, 0.5)};
  return g;
}

TEST(Choice, FollowsTheWeights) {
  const int64_t n = 100000;
  std::map<std::string, double> seen;
  const Tree tree = derive(weighted(n), RandomKey(11));
  for (const int leaf : tree.leaves()) ++seen[tree.nodes[static_cast<size_t>(leaf)].symbol.name];
  EXPECT_EQ(seen.count("never"), 0u);
  double chi2 = 0;
  for (const auto& [name, weight] : std::map<std::string, double>{{"a", 3}, {"b", 1}, {"c", 0.5}}) {
    const double expected = static_cast<double>(n) * weight / 4.5;
    chi2 += (seen[name] - expected) * (seen[name] - expected) / expected;
  }
  EXPECT_LT(chi2, 13.8);  // 2 degrees of freedom, p = 0.001
}

TEST(Choice, IsIndependentBetweenNeighbours) {
  const int64_t n = 90000;
  const Tree tree = derive(weighted(n), RandomKey(12));
  const auto leaves = tree.leaves();
  // Pairs (a or not, a or not) of neighbours: 2 x 2 table against the product of 2/3 and 1/3.
  double table[2][2] = {};
  for (size_t i = 0; i + 1 < leaves.size(); i += 2) {
    const auto is_a = [&](size_t k) {
      return tree.nodes[static_cast<size_t>(leaves[k])].symbol.name == "a" ? 0 : 1;
    };
    ++table[is_a(i)][is_a(i + 1)];
  }
  const double share[2] = {2.0 / 3, 1.0 / 3};
  double chi2 = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const double expected = static_cast<double>(n) / 2 * share[i] * share[j];
      chi2 += (table[i][j] - expected) * (table[i][j] - expected) / expected;
    }
  EXPECT_LT(chi2, 16.3);  // 3 degrees of freedom, p = 0.001
}

TEST(Choice, MoreRepetitionsLeaveTheEarlierOnes) {
  const Tree few = derive(weighted(50), RandomKey(3)), many = derive(weighted(80), RandomKey(3));
  EXPECT_EQ(word(many).substr(0, word(few).size()), word(few));
}

/// The text of the subtree at the path.
std::string below(const Tree& tree, const std::string& name) {
  std::string out;
  for (size_t i = 0; i < tree.nodes.size(); ++i)
    if (tree.path(static_cast<int>(i)).find("/" + name) != std::string::npos)
      out += to_string(tree.nodes[i].symbol) + " ";
  return out;
}

TEST(Choice, OneBranchDoesNotChangeAnother) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    Grammar g = shrub();
    const SuccessorItem branch = g.axiom[0];
    g.axiom = {part("Left"), part("Right")};
    g.productions.push_back(rule("Left", {branch}));
    g.productions.push_back(rule("Right", {branch}));
    const std::string right = below(derive(g, RandomKey(seed)), "Right");
    // The left branch gets another production, and a third branch precedes both.
    g.productions[2].successor = {branch, branch, terminal("moss")};
    g.axiom.insert(g.axiom.begin(), part("Middle"));
    g.productions.push_back(rule("Middle", {branch}));
    ASSERT_EQ(below(derive(g, RandomKey(seed)), "Right"), right) << seed;
  }
}

TEST(Choice, SeedsDiffer) {
  EXPECT_NE(tree_text(derive(shrub(), RandomKey(1))), tree_text(derive(shrub(), RandomKey(2))));
}

}  // namespace
}  // namespace vug::grammar
