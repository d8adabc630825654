// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/base/parallel.h>
#include <vug/grammar/tree_output.h>
#include <vug/sgm/probe.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::sgm {
namespace {

constexpr uint64_t kSeeds = 100;

/// The bounding box of the solid's points on a lattice of 0.25 m.
Box3d box_of(const Field& f) {
  constexpr double kStep = 0.25;
  Box3d out;
  Vec3i low, high;
  for (int i = 0; i < 3; ++i) {
    low[i] = static_cast<int>(std::floor(f.bounds().min[i] / kStep));
    high[i] = static_cast<int>(std::ceil(f.bounds().max[i] / kStep));
  }
  for (int x = low.x; x <= high.x; ++x)
    for (int y = low.y; y <= high.y; ++y)
      for (int z = low.z; z <= high.z; ++z) {
        const Vec3d p = Vec3d(x, y, z) * kStep;
        if (f.value(p) < 0) out.extendBy(p);
      }
  return out;
}

// The paper's experiment: LD=10 PC=10 PM=2 LB=+X MP=52% PS=3.
TEST(Figure9, HasTwelveProductionsAndGrowsAlongX) {
  std::vector<double> gain(kSeeds), slender(kSeeds);
  parallel_for(kSeeds, [&](size_t seed) {
    const DerivationResult cave = derive(figure9(), RandomKey(seed));
    EXPECT_EQ(cave.counts.classic, 10);
    EXPECT_EQ(cave.counts.morphic, 2);
    EXPECT_EQ(cave.counts.total(), 12);
    EXPECT_EQ(cave.operations.size(), 12u);
    EXPECT_TRUE(cave.diagnostics.all().empty());
    EXPECT_TRUE(inner_point(cave.field));
    const Box3d all = box_of(cave.field), first = box_of(cave.operations[0].field);
    gain[seed] = all.max.x - first.max.x;
    slender[seed] = all.size().x / std::max(all.size().y, all.size().z);
    for (const Placement& p : cave.operations) EXPECT_EQ(p.side, Label::plus_x);
  });
  double mean = 0;
  for (uint64_t seed = 0; seed < kSeeds; ++seed) {
    EXPECT_GT(gain[seed], 0) << seed;
    mean += slender[seed] / kSeeds;
  }
  // Without a direction the mean would be near 1.
  EXPECT_GT(mean, 2);
}

TEST(Figure9, IsTheSameOnAnyNumberOfThreads) {
  const auto fingerprint = [](int threads) {
    return with_threads(threads, [&] {
      std::vector<std::string> out(16);
      parallel_for(out.size(), [&](size_t seed) {
        const DerivationResult cave = derive(figure9(), RandomKey(seed));
        out[seed] = grammar::tree_json(cave.tree);
        for (double x = -2; x < 12; x += 0.37)
          out[seed] += to_string(Value(cave.field.value({x, 0.1, 0.2}))) + " ";
      });
      return out;
    });
  };
  const auto one = fingerprint(1);
  EXPECT_EQ(one, fingerprint(2));
  EXPECT_EQ(one, fingerprint(7));
  EXPECT_NE(one[0], one[1]);
}

TEST(Rules, DistributeMorphicProductionsAmongTheClassicOnes) {
  Rules rules = figure9();
  const auto order = [&] {
    std::string out;
    for (const grammar::SuccessorItem& part : grammar_of(rules).axiom) {
      grammar::Symbol symbol;
      const int64_t n = part.count({symbol, RandomKey(1), RandomKey(1)});
      for (int64_t i = 0; i < n; ++i) out += part.symbol[0];
    }
    return out;
  };
  EXPECT_EQ(order(), "CCCMCCCMCCCC");
  rules.morphic = 0;
  EXPECT_EQ(order(), "CCCCCCCCCC");
  rules.classic = 0;
  rules.morphic = 3;
  EXPECT_EQ(order(), "MMM");
}

TEST(Rules, OperationsFollowTheirWeights) {
  Rules rules = figure9();
  rules.classic = 6000;
  rules.morphic = 0;
  rules.pieces = 1;
  std::map<std::string, double> seen;
  const grammar::Tree tree = grammar::derive(grammar_of(rules), RandomKey(5));
  for (const int leaf : tree.leaves()) ++seen[tree.nodes[static_cast<size_t>(leaf)].symbol.name];
  double chi2 = 0;
  for (const auto& [name, n] : std::map<std::string, double>{{"+", 4000}, {"-", 1000}, {"&", 1000}})
    chi2 += (seen[name] - n) * (seen[name] - n) / n;
  EXPECT_LT(chi2, 13.8);  // 2 degrees of freedom, p = 0.001
}

TEST(Rules, PiecesMakeCompoundShapes) {
  Rules rules = figure9();
  for (const int pieces : {0, 1, 4}) {
    rules.pieces = pieces;
    const DerivationResult cave = derive(rules, RandomKey(3));
    const auto joins =
        std::count(cave.operations[0].shape.begin(), cave.operations[0].shape.end(), '+');
    EXPECT_EQ(joins, std::max(pieces, 1) - 1);
  }
}

TEST(Rules, InvalidParametersAreRefused) {
  const auto refused = [](auto change) {
    Rules rules = figure9();
    change(rules);
    EXPECT_THROW(derive(rules, RandomKey(1)), Error);
  };
  refused([](Rules& r) { r.classic = r.morphic = 0; });
  refused([](Rules& r) { r.morphic = -1; });
  refused([](Rules& r) { r.pieces = -1; });
  refused([](Rules& r) { r.amount = 1.01; });
  refused([](Rules& r) { r.shapes.clear(); });
  refused([](Rules& r) { r.shapes[0].weight = -1; });
  refused([](Rules& r) { r.unite = -1; });
}

TEST(Interpret, WarnsAboutUnexpandedSymbols) {
  grammar::Grammar g;
  g.axiom.resize(1);
  g.axiom[0].symbol = "Room";
  const DerivationResult cave = sgm::derive(g, RandomKey(1));
  ASSERT_EQ(cave.diagnostics.all().size(), 1u);
  EXPECT_EQ(cave.diagnostics.all()[0].message,
            "'Room' at grammar/Room[0] was never expanded to a production");
  EXPECT_EQ(cave.counts.total(), 0);
}

TEST(Interpret, CountsLeavesOfTheTree) {
  const DerivationResult cave = derive(figure9(), RandomKey(1));
  for (const Placement& p : cave.operations) {
    const grammar::Node& leaf = cave.tree.nodes[static_cast<size_t>(p.node)];
    EXPECT_EQ(leaf.symbol.name, sign_of(p.operation));
    EXPECT_EQ(cave.tree.nodes[static_cast<size_t>(leaf.parent)].symbol.name,
              p.operation == Operation::morph ? "Morphic" : "Classic");
  }
}

}  // namespace
}  // namespace vug::sgm
