// SPDX-License-Identifier: Apache-2.0
// The step counter: which cells are updated, which are visible, and the order of rules.
#include "run.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>

#include <gtest/gtest.h>

#include <atomic>

namespace vug::cells {
namespace {

TEST(Rules, AreDocumentedAndGiveTheSameBytesForAnyNumberOfThreads) {
  const NetworkPtr n = uneven(0.05);
  for (const RuleKind* kind : rules()) {
    EXPECT_FALSE(kind->info.doc.empty()) << kind->info.name;
    NamedValues parameters;
    for (const ParamInfo& param : kind->info.params)
      if (param.required)
        parameters.emplace_back(param.name, param.type == "text" ? Value("v") : Value(0.5));
    const std::vector<Stage> stages = {
        stage("random_color", {{"share", 0.1}}, 1),
        stage("sprinkle", {{"attribute", "v"}, {"share", 0.01}, {"radius", 0.1}}, 1),
        stage("sprinkle", {{"attribute", "alive"}, {"whole", true}}, 1),
        stage("corrosion", {{"share", 0.2}}),  // So that some cells sleep.
        stage(kind->info.name, parameters)};
    std::vector<std::pair<std::string, Digest>> expected;
    for (const int threads : {1, 2, 5, 8}) {
      with_threads(threads, [&] {
        const Simulation s = ran(n, stages, 25);
        std::vector<std::pair<std::string, Digest>> got;
        for (const Attribute& a : s.attributes().all())
          std::visit(
              [&](const auto& c) {
                got.emplace_back(a.name, vug::digest(c.now.data(), c.now.size() * sizeof c.now[0]));
              },
              a.column);
        got.emplace_back("state", vug::digest(s.states().data(), s.states().size()));
        if (threads == 1) expected = got;
        EXPECT_EQ(got, expected) << kind->info.name << " " << threads;
      });
    }
  }
}

TEST(States, DetermineUpdatedAndVisibleCells) {
  const NetworkPtr n = uneven();
  Simulation s(n, RandomKey(1));
  std::vector<CellState> states;
  RandomStream random(RandomKey(2));
  for (size_t i = 0; i < n->size(); ++i) states.push_back(static_cast<CellState>(random.below(5)));
  s.run({stage("random_color")}, 1);
  std::vector<Vec3f> expected = s.attributes().values<Vec3f>("Cd");
  s.set_states(states);
  for (int step = 0; step < 20; ++step) {
    s.run({stage("spreading_color")}, 1);
    const std::vector<Vec3f> now = expected;
    for (uint32_t i = 0; i < n->size(); ++i) {
      if (!receives(states[i])) continue;
      Vec3f sum = now[i];
      float count = 1;
      for (const uint32_t to : n->links.of(i))
        if (distributes(states[to])) sum += now[to], ++count;
      expected[i] = sum / count;
    }
    ASSERT_EQ(s.attributes().values<Vec3f>("Cd"), expected) << step;
  }
}

/// Counts its cells and adds 1 to each.
struct Counting : Rule {
  mutable std::atomic<int> cells{0};

  void step(Pass& pass) const override {
    const auto count = pass.writes<int32_t>("count");
    pass.run([&](const auto&, uint32_t i) {
      ++cells;
      count.set(i, count[i] + 1);
    });
  }
};

TEST(Sleep, CostsNothingAndKeepsValues) {
  const NetworkPtr n = torus(200, 100, 4);
  Simulation s(n, RandomKey(1));
  const auto counting = std::make_shared<Counting>();
  const std::vector<Stage> count = {{counting, "count", 0, -1, {}}};
  s.run(count, 3);
  std::vector<CellState> states(n->size(), CellState::active);
  for (size_t i = 0; i < 15000; ++i) states[i] = CellState::sleeping;
  s.set_states(states);
  counting->cells = 0;
  s.run(count, 4);
  EXPECT_EQ(counting->cells, 4 * 5000);
  s.run({stage("sleep", {}, 1, s.step())}, 1);
  s.run(count, 2);
  EXPECT_EQ(counting->cells, 4 * 5000);
  s.run({stage("wake")}, 1);
  s.run(count, 1);
  for (uint32_t i = 0; i < n->size(); ++i)
    ASSERT_EQ(s.attributes().values<int32_t>("count")[i], i < 15000 ? 4 : 8);
}

TEST(Stages, RunAtTheirTimeAndPlace) {
  const NetworkPtr n = torus(100, 50, 4);
  Simulation s(n, RandomKey(1));
  Stage late{std::make_shared<Counting>(), "late", 2, 3, {}};
  late.where.assign(n->size(), 0);
  for (size_t i = 0; i < n->size(); i += 3) late.where[i] = 1;
  s.run({late}, 4);
  s.run({late}, 6);
  for (uint32_t i = 0; i < n->size(); ++i)
    ASSERT_EQ(s.attributes().values<int32_t>("count")[i], i % 3 == 0 ? 3 : 0);
  late.where.pop_back();
  EXPECT_THROW(s.run({late}, 1), Error);
}

TEST(Stages, ComposeOnTheSameCells) {
  // Figure 10 (f): cracks remain while the rest of the colour continues to spread.
  const NetworkPtr n = uneven();
  Simulation s(n, RandomKey(3));
  const std::vector<Stage> stages = {
      stage("random_color", {{"share", 0.01}}, 1), stage("voronoi", {}, 60),
      stage("crack", {{"color", Vec3d(0.25, 0, 0)}}, 1, 60), stage("spreading_color", {}, -1, 61)};
  s.run(stages, 61);
  const std::vector<Vec3f> cracked = s.attributes().values<Vec3f>("Cd");
  const std::vector<CellState> states = s.states();
  s.run(stages, 20);
  const auto& color = s.attributes().values<Vec3f>("Cd");
  for (uint32_t i = 0; i < n->size(); ++i) {
    // A patch has one colour, whose mean is that colour, up to rounding.
    const Vec3f expected = states[i] == CellState::sleeping ? Vec3f(0.25f, 0, 0) : cracked[i];
    ASSERT_LT((color[i] - expected).length(), states[i] == CellState::sleeping ? 1e-30f : 1e-5f);
  }
}

TEST(Stages, CanBeCancelledAndRefuseWrongTypes) {
  Simulation s(torus(20, 20, 4), RandomKey(1));
  s.attributes().column<float>("alive");
  EXPECT_THROW(s.run({stage("life")}, 1), Error);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(s.run({stage("melting")}, 5, progress), Error);
}

}  // namespace
}  // namespace vug::cells
