// SPDX-License-Identifier: Apache-2.0
// The graph of drips: where water seeps, that none is lost, and that ids last.
#include <vug/base/parallel.h>
#include <vug/drips/build_graph.h>
#include <vug/drips/chemistry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "rooms.h"

namespace vug::drips {
namespace {

std::vector<Node> nodes_of(const Graph& graph, NodeKind kind) {
  std::vector<Node> out;
  for (const Node& node : graph.nodes)
    if (node.kind == kind) out.push_back(node);
  return out;
}

TEST(Seeps, LieOnRoofsAndGiveHeavyTailedDischarge) {
  const field::Field rock = cave(20, 0.05, 20);
  SeepOptions o = graph_options(10);
  const std::vector<Seep> seeps = find_seeps(rock, o);
  ASSERT_GT(seeps.size(), 700u);  // About half of 2500 columns.
  ASSERT_LT(seeps.size(), 1700u);
  std::vector<double> intervals;
  double sum = 0, squares = 0;
  for (const Seep& seep : seeps) {
    EXPECT_NEAR(rock.value(seep.position), 0, 1e-6);
    EXPECT_LT(seep.normal.y, 0);
    EXPECT_LE(seep.age, o.oldest);
    intervals.push_back(seep.interval);
    sum += std::log(seep.interval);
    squares += std::log(seep.interval) * std::log(seep.interval);
  }
  const auto n = static_cast<double>(seeps.size());
  EXPECT_NEAR(std::log(median(intervals)), std::log(60), 0.15);
  EXPECT_NEAR(std::sqrt(squares / n - sum * sum / n / n), 1.2, 0.1);
}

TEST(Seeps, AreClustered) {
  // Counts in squares of four spacings vary more than those of independent places (Poisson).
  SeepOptions o = graph_options(10);
  std::map<std::pair<int, int>, double> counts;
  for (int x = -6; x < 6; ++x)
    for (int z = -6; z < 6; ++z) counts[{x, z}] = 0;
  for (const Seep& seep : find_seeps(hall(20, 0.05, 20), o)) {
    const auto count = counts.find({static_cast<int>(std::floor(seep.position.x / 1.6)),
                                    static_cast<int>(std::floor(seep.position.z / 1.6))});
    if (count != counts.end()) ++count->second;
  }
  double sum = 0, squares = 0;
  for (const auto& [place, count] : counts) sum += count, squares += count * count;
  const auto n = static_cast<double>(counts.size());
  const double mean = sum / n, variance = squares / n - mean * mean;
  // A column gives at most one seep: with a density of 1/2 the variance would be half the mean.
  EXPECT_GT(variance, 1.2 * mean);
}

TEST(Drips, LieNearerToJointsThanRandomSites) {
  const field::Field rock = cave(20, 0.05, 20);
  const Planes planes = joints();
  GraphOptions o = graph_options(10);
  o.run_out = false;
  const auto distances = [&] {
    std::vector<double> out;
    for (const Node& drop : nodes_of(build_graph(rock, o), NodeKind::drop))
      out.push_back(std::fabs(planes.nearest(drop.position)->distance));
    return out;
  };
  const double at_random = median(distances());
  EXPECT_NEAR(at_random, 0.5, 0.12);  // A quarter of the spacing.
  o.planes = planes;
  EXPECT_LT(median(distances()), at_random / 3);
  EXPECT_FALSE(build_graph(rock, o).planes.empty());
}

TEST(Drips, FallFromTheTipToTheFloorBelow) {
  const field::Field rock = cave();
  const Graph graph = build_graph(rock, graph_options());
  int falls = 0;
  for (const Edge& edge : graph.edges) {
    if (edge.kind != EdgeKind::fall) continue;
    ++falls;
    const Node &drop = graph.nodes[static_cast<size_t>(edge.from)],
               &landing = graph.nodes[static_cast<size_t>(edge.to)];
    EXPECT_EQ(drop.kind, NodeKind::drop);
    EXPECT_EQ(landing.kind, NodeKind::landing);
    EXPECT_EQ(drop.id, landing.id);
    const auto aside = [](const Vec3d& p, const Vec3d& q) {
      return std::hypot(p.x - q.x, p.z - q.z);
    };
    // Young stalactites have not reached the plumb line of the place to which they lean.
    EXPECT_LE(aside(drop.tip, landing.position), drop.growth < 0.5 ? 0.03 : 1e-9);
    EXPECT_LE(aside(drop.tip, drop.position), std::tan(3.5 * kPi / 180) * drop.growth + 1e-9);
    EXPECT_NEAR(rock.value(landing.position), 0, 1e-5);
    EXPECT_LT(landing.position.y, drop.position.y);
  }
  EXPECT_GT(falls, 40);
}

TEST(Drips, NoWaterIsLostOnTheWay) {
  for (const bool planes : {false, true}) {
    GraphOptions o = graph_options();
    if (planes) o.planes = joints();
    const Graph graph = build_graph(cave(), o);
    std::vector<double> in(graph.nodes.size()), out(graph.nodes.size());
    std::set<int> left;  // Nodes whose water has run on.
    for (const Edge& edge : graph.edges) {
      EXPECT_GE(edge.path.size(), 2u);
      EXPECT_FALSE(left.contains(edge.to)) << "edges into a node come first";
      left.insert(edge.from);
      in[static_cast<size_t>(edge.to)] += edge.water.discharge;
      out[static_cast<size_t>(edge.from)] += edge.water.discharge;
    }
    double seeped = 0, ended = 0;
    for (size_t i = 0; i < graph.nodes.size(); ++i) {
      const Node& node = graph.nodes[i];
      const double through = node.water.discharge;
      EXPECT_GE(node.water.calcium, equilibrium_calcium(10) - 1e-12);
      EXPECT_LE(node.water.calcium, seep_calcium(10) + 1e-12);
      if (out[i] > 0) {
        EXPECT_NEAR(out[i], through, 1e-12 * through);
      }
      if (out[i] == 0) ended += through;
      if (node.kind == NodeKind::seep)
        seeped += through - in[i];
      else
        EXPECT_NEAR(in[i], through, 1e-12 * through);
    }
    EXPECT_GT(seeped, 0);
    EXPECT_NEAR(ended, seeped, 1e-9 * seeped);
    EXPECT_FALSE(nodes_of(graph, NodeKind::pool).empty());
  }
}

TEST(Drips, PoolsRunOverIntoLowerOnes) {
  GraphOptions o = graph_options(10);
  const Graph graph = build_graph(cave(20, 0.05, 20), o);
  int overflows = 0;
  for (const Edge& edge : graph.edges) {
    const Node &from = graph.nodes[static_cast<size_t>(edge.from)],
               &to = graph.nodes[static_cast<size_t>(edge.to)];
    if (edge.kind != EdgeKind::overflow || to.kind != NodeKind::pool) continue;
    ++overflows;
    EXPECT_GE(from.level, to.level - 2e-3);
  }
  EXPECT_GT(overflows, 5);
  for (const Node& pool : nodes_of(graph, NodeKind::pool)) EXPECT_GE(pool.level, pool.position.y);
}

TEST(Drips, KeepTheirIdsWhenOthersAreAdded) {
  GraphOptions o = graph_options();
  o.run_out = false;
  const auto places = [&] {
    std::map<int64_t, Vec3d> out;
    for (const Node& seep : nodes_of(build_graph(cave(), o), NodeKind::seep))
      EXPECT_TRUE(out.emplace(seep.id, seep.position).second) << "an id is unique";
    return out;
  };
  o.density = 0.3;
  const auto few = places();
  o.density = 0.6;
  const auto many = places();
  EXPECT_GT(many.size(), few.size() + 10);
  for (const auto& [id, place] : few) {
    ASSERT_TRUE(many.contains(id));
    EXPECT_EQ(many.at(id), place);
  }
}

TEST(Drips, TheMaskSelectsAllOrNone) {
  GraphOptions o = graph_options();
  // A distant half-space has nearly the same value everywhere within the size of the box.
  const auto everywhere = [](double value) {
    return field::Noise(field::make("half_space", {{"offset", -value * 1e6}}), {-2e6, 2e6});
  };
  o.where = everywhere(-1);
  EXPECT_TRUE(build_graph(hall(), o).nodes.empty());
  o.where = everywhere(1);
  EXPECT_GE(find_seeps(hall(), o).size(), 200u);  // 225 places, some too close to a wall.
}

TEST(Drips, AreTheSameForAnyNumberOfThreads) {
  GraphOptions o = graph_options();
  o.planes = joints();
  const auto graph_with = [&](int threads) {
    return with_threads(threads, [&] { return build_graph(cave(), o); });
  };
  const Graph one = graph_with(1);
  for (const int threads : {2, 7}) {
    const Graph other = graph_with(threads);
    ASSERT_EQ(one.nodes.size(), other.nodes.size());
    ASSERT_EQ(one.edges.size(), other.edges.size());
    for (size_t i = 0; i < one.nodes.size(); ++i) {
      EXPECT_EQ(one.nodes[i].position, other.nodes[i].position);
      EXPECT_EQ(one.nodes[i].water.calcium, other.nodes[i].water.calcium);
      EXPECT_EQ(one.nodes[i].kind, other.nodes[i].kind);
      EXPECT_EQ(one.nodes[i].id, other.nodes[i].id);
    }
    for (size_t i = 0; i < one.edges.size(); ++i) EXPECT_EQ(one.edges[i].path, other.edges[i].path);
  }
}

TEST(Drips, NeedRoofsInTheAir) {
  EXPECT_TRUE(build_graph(field::empty(), graph_options()).nodes.empty());
  EXPECT_TRUE(build_graph(field::complement(field::empty()), graph_options()).nodes.empty());
}

TEST(Drips, RefuseImpossibleOptions) {
  const auto refused = [](auto change, const std::string& words) {
    GraphOptions o = graph_options();
    change(o);
    try {
      build_graph(hall(), o);
      ADD_FAILURE() << "accepted, expected: " << words;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_FALSE(error.hint().empty());
    }
  };
  const double nan = std::nan("");
  refused([&](GraphOptions& o) { o.interval = 0; }, "water must flow");
  refused([&](GraphOptions& o) { o.interval = kInfinity; }, "water must flow");
  refused([&](GraphOptions& o) { o.from.x = nan; }, "empty or not finite");
  refused([&](GraphOptions& o) { o.to = o.from; }, "empty or not finite");
  refused([&](GraphOptions& o) { o.spacing = 0; }, "spacing");
  refused([&](GraphOptions& o) { o.oldest = -1; }, "age");
  refused([&](GraphOptions& o) { o.temperature = nan; }, "degrees");
  refused([&](GraphOptions& o) { o.spacing = 1.8e-3; }, "millions");
  refused([&](GraphOptions& o) { o.spacing = 6e-3, o.memory = 1 << 30; }, "memory");
}

}  // namespace
}  // namespace vug::drips
