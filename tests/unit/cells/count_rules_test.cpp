// SPDX-License-Identifier: Apache-2.0
// The counting rules of table 1: corrosion, life, maze, regrouping; and Gray-Scott.
#include "run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::cells {
namespace {

/// The game on rows of text, with neighbours found by modular arithmetic.
std::vector<int32_t> next_generation(const std::vector<int32_t>& now, int width, int height) {
  std::vector<int32_t> next(now.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      int living = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (dx != 0 || dy != 0)
            living += now[static_cast<size_t>((y + dy + height) % height * width +
                                              (x + dx + width) % width)];
      const auto at = static_cast<size_t>(y * width + x);
      next[at] = living == 3 || (living == 2 && now[at] == 1) ? 1 : 0;
    }
  return next;
}

const Stage kHalfAlive = stage("sprinkle", {{"attribute", "alive"}, {"whole", true}});

TEST(Life, IsTheGameForAThousandGenerations) {
  Simulation s = ran(torus(96, 64, 8), {kHalfAlive}, 1, 7);
  std::vector<int32_t> expected = s.attributes().values<int32_t>("alive");
  EXPECT_NEAR(std::accumulate(expected.begin(), expected.end(), 0), 96 * 32, 4 * 40);
  for (int ten = 0; ten < 100; ++ten) {
    s.run({stage("life")}, 10);
    for (int i = 0; i < 10; ++i) expected = next_generation(expected, 96, 64);
    ASSERT_EQ(s.attributes().values<int32_t>("alive"), expected) << ten;
  }
  EXPECT_GT(std::accumulate(expected.begin(), expected.end(), 0), 0);
}

TEST(Life, ScaledCountsAsEight) {
  // With six neighbours, 2 count as round(8 * 2 / 6) = 3: a pair causes a birth next to it.
  Simulation s(torus(12, 12, 6), RandomKey(1));
  auto& alive = s.attributes().column<int32_t>("alive").now;
  alive[5 * 12 + 5] = alive[5 * 12 + 6] = 1;
  s.run({stage("life", {{"scale", true}})}, 1);
  int born = 0;
  for (uint32_t i = 0; i < s.network().size(); ++i) {
    int living = 0;
    for (const uint32_t n : s.network().links.of(i)) living += n == 65 || n == 66;
    const bool expected = living == 2;
    ASSERT_EQ(s.attributes().values<int32_t>("alive")[i] != 0, expected) << i;
    born += expected;
  }
  EXPECT_EQ(born, 2);
}

TEST(Maze, FillsHalfOfTheFloor) {
  Simulation s = ran(torus(256, 256, 8), {kHalfAlive}, 1, 11);
  s.run({stage("maze")}, 400);
  const auto& alive = s.attributes().values<int32_t>("alive");
  EXPECT_NEAR(std::accumulate(alive.begin(), alive.end(), 0.0) / 65536, 0.505, 0.02);
}

TEST(Corrosion, EqualsAPlainLoop) {
  const NetworkPtr n = uneven();
  Simulation s(n, RandomKey(6));
  const float loss = 0.25f;
  const NamedValues parameters = {{"share", 0.4}, {"potential", 1}, {"loss", 0.25}};
  s.run({stage("corrosion", parameters)}, 1);
  std::vector<float> p = s.attributes().values<float>("potential");
  const auto struck = std::count(p.begin(), p.end(), 1.0f);
  EXPECT_NEAR(static_cast<double>(struck), 0.4 * static_cast<double>(n->size()),
              4 * std::sqrt(0.24 * static_cast<double>(n->size())));
  std::vector<bool> gone(n->size(), false);
  // A new stage would attack again, so the old one continues.
  Simulation all = ran(n, {stage("corrosion", parameters)}, 12, 6);
  for (int step = 1; step < 12; ++step) {
    const std::vector<float> now = p;
    const std::vector<bool> was_gone = gone;
    for (uint32_t i = 0; i < n->size(); ++i) {
      if (was_gone[i]) continue;
      if (now[i] > 0) {
        p[i] = std::max(0.0f, now[i] - loss);
        gone[i] = p[i] == 0;
        continue;
      }
      int seen = 0, carry = 0;
      for (const uint32_t to : n->links.of(i))
        if (!was_gone[to]) ++seen, carry += now[to] > 0;
      if (2 * carry > seen) p[i] = 1;
    }
  }
  EXPECT_EQ(all.attributes().values<float>("potential"), p);
  for (uint32_t i = 0; i < n->size(); ++i)
    ASSERT_EQ(all.states()[i], gone[i] ? CellState::transparent : CellState::active);
  EXPECT_GT(std::count(gone.begin(), gone.end(), true), struck);
}

TEST(Corrosion, AttacksWholePatchesIfThereAreAny) {
  const NetworkPtr n = uneven();
  Simulation s(n, RandomKey(8));
  s.run({stage("random_color", {{"share", 0.02}})}, 1);
  s.run({stage("voronoi")}, 60);
  s.run({stage("corrosion", {{"share", 0.5}})}, 1);
  const auto& seed = s.attributes().values<int32_t>("seed");
  const auto& p = s.attributes().values<float>("potential");
  std::vector<int> fate(n->size() + 1, -1);
  for (uint32_t i = 0; i < n->size(); ++i) {
    int& own = fate[static_cast<size_t>(seed[i])];
    const int struck = p[i] > 0 ? 1 : 0;
    if (own < 0) own = struck;
    ASSERT_EQ(own, struck);
  }
}

TEST(Regrouping, BecomesConstantOrPeriodic) {
  // With symmetric weights the sum of J_ij s_i(t) s_j(t-1), and of h (s_i(t) + s_i(t-1)), never
  // decreases under synchronous updates (Goles and Olivos 1981): finally groups repeat after two
  // steps.
  const NetworkPtr n = uneven(0.09);
  const double h = 0.2511, near = 1.8, far = 3.5;
  const std::vector<Stage> stages = {
      stage("regrouping", {{"near", near}, {"far", far}, {"repel", -0.3137}, {"bias", h}})};
  Simulation s(n, RandomKey(9));
  const auto votes = [&](uint32_t i, uint32_t j) {
    const double d = static_cast<double>((n->position[i] - n->position[j]).length()) / n->spacing;
    return i == j || d >= far || n->normal[i].dot(n->normal[j]) <= 0 ? 0 : d < near ? 1.0 : -0.3137;
  };
  std::vector<std::vector<int32_t>> seen;
  for (int step = 0; step < 60; ++step) {
    s.run(stages, 1);
    seen.push_back(s.attributes().values<int32_t>("group"));
  }
  EXPECT_EQ(seen[59], seen[57]);
  EXPECT_NE(seen[1], seen[0]);
  double last = -1e30;
  for (size_t t = 1; t < 8; ++t) {
    double sum = 0;
    for (uint32_t i = 0; i < n->size(); ++i) {
      double field = h;
      for (uint32_t j = 0; j < n->size(); ++j) field += votes(i, j) * seen[t - 1][j];
      ASSERT_EQ(seen[t][i], field > 1e-9    ? 1
                            : field < -1e-9 ? -1
                                            : seen[t - 1][i])
          << t << " " << i;
      sum += field * seen[t][i] + h * seen[t - 1][i];
    }
    ASSERT_GE(sum, last - 1e-6) << t;
    last = sum;
  }
}

TEST(GrayScott, ConservesMassAndEqualsAPlainLoop) {
  const std::vector<Stage> drops = {
      stage("sprinkle", {{"attribute", "v"}, {"share", 0.002}, {"radius", 0.2}})};
  const NetworkPtr n = uneven();
  Simulation closed = ran(n, drops, 1);
  closed.attributes().column<float>("u", 1);
  const auto total = [&](const Simulation& s) {
    double sum = 0;
    for (const char* name : {"u", "v"})
      for (const float x : s.attributes().values<float>(name)) sum += static_cast<double>(x);
    return sum;
  };
  const double before = total(closed);
  closed.run({stage("gray_scott", {{"feed", 0}, {"kill", 0}})}, 200);
  EXPECT_NEAR(total(closed) / before, 1, 1e-5);

  const int side = 40;
  Simulation open =
      ran(torus(side, side, 8),
          {stage("sprinkle", {{"attribute", "v"}, {"share", 0.01}, {"radius", 3}})}, 1);
  std::vector<double> u(side * side, 1.0), v;
  for (const float x : open.attributes().values<float>("v")) v.push_back(static_cast<double>(x));
  const double f = 0.03, k = 0.06, du = 0.8, dv = 0.4;
  open.run({stage("gray_scott", {{"feed", f}, {"kill", k}})}, 100);
  for (int step = 0; step < 100; ++step) {
    const std::vector<double> u0 = u, v0 = v;
    for (int at = 0; at < side * side; ++at) {
      double spread_u = 0, spread_v = 0;
      for (int d = 0; d < 9; ++d) {
        const int x = (at % side + d % 3 - 1 + side) % side;
        const int y = (at / side + d / 3 - 1 + side) % side;
        spread_u += u0[static_cast<size_t>(y * side + x)] - u0[static_cast<size_t>(at)];
        spread_v += v0[static_cast<size_t>(y * side + x)] - v0[static_cast<size_t>(at)];
      }
      const auto i = static_cast<size_t>(at);
      const double uvv = u0[i] * std::min(1.0, v0[i] * v0[i]);
      u[i] += du * spread_u / 8 - uvv + f * (1 - u0[i]);
      v[i] += dv * spread_v / 8 + uvv - (f + k) * v0[i];
    }
  }
  for (size_t i = 0; i < u.size(); ++i) {
    ASSERT_NEAR(open.attributes().values<float>("u")[i], u[i], 1e-4);
    ASSERT_NEAR(open.attributes().values<float>("v")[i], v[i], 1e-4);
  }
  EXPECT_GT(std::accumulate(v.begin(), v.end(), 0.0), 1);  // It is active.
}

TEST(GrayScott, IsTheSameForEachCellAloneAndForBlocks) {
  // Blocks with all linked cells nearby, blocks with distant links, and links of many degrees.
  for (const NetworkPtr& network : {torus(40, 1000, 8), torus(200, 200, 6), uneven(0.01)}) {
    ASSERT_GT(network->size(), 4 * kBlock);
    const std::vector<Stage> drops = {stage("sprinkle", {{"attribute", "v"}, {"share", 0.1}})};
    Simulation blocks = ran(network, drops, 1), cells = ran(network, drops, 1);
    Stage masked = stage("gray_scott");
    masked.where.assign(network->size(), 1);
    blocks.run({stage("gray_scott")}, 20);
    cells.run({masked}, 20);
    for (const char* name : {"u", "v"})
      EXPECT_EQ(blocks.attributes().values<float>(name), cells.attributes().values<float>(name));
  }
}

TEST(GrayScott, IsTheSameWhereSomeBlocksSleep) {
  // Two sheets in one network of more than a block each: if one sleeps, the other is unaffected.
  Network both = flat_torus(132, 64, 8);
  const auto count = static_cast<uint32_t>(both.size());
  const NetworkPtr one = std::make_shared<const Network>(both);
  const auto twice = [&](auto& list) {
    list.reserve(2 * list.size());
    list.insert(list.end(), list.begin(), list.begin() + static_cast<int64_t>(list.size()));
  };
  twice(both.position), twice(both.normal), twice(both.right), twice(both.area), twice(both.object);
  both.links = make_links(2 * count, [&](uint32_t i, const auto& add) {
    for (const uint32_t to : one->links.of(i % count)) add(to + i / count * count);
  });
  const std::vector<Stage> drops = {stage("sprinkle", {{"attribute", "v"}, {"share", 0.1}})};
  Simulation awake = ran(one, drops, 1);
  Simulation half = ran(std::make_shared<const Network>(both), drops, 1);
  std::vector<CellState> states(2 * count, CellState::active);
  std::fill(states.begin() + count, states.end(), CellState::sleeping);
  half.set_states(states);
  awake.run({stage("gray_scott")}, 30);
  half.run({stage("gray_scott")}, 30);
  for (const char* name : {"u", "v"}) {
    const auto& expected = awake.attributes().values<float>(name);
    const auto& got = half.attributes().values<float>(name);
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), got.begin())) << name;
  }
}

}  // namespace
}  // namespace vug::cells
