// SPDX-License-Identifier: Apache-2.0
// The equations of docs/explanation/theory/networks.md: costs of legs and directions, gamma graph.
#include <gtest/gtest.h>
#include <vug/base/rng.h>
#include <vug/karst/rock.h>
#include <vug/karst/skeleton.h>

#include <cmath>

namespace vug::karst {
namespace {

/// Each point with all others, in a cube of 80 m around the origin.
SampleGraph complete_graph(int count) {
  RandomStream random(RandomKey(11));
  std::vector<Vec3d> points;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-40, 40), y = random.uniform(-40, 40);
    points.emplace_back(x, y, random.uniform(-40, 40));
  }
  return build_graph(std::move(points), count - 1);
}

double mean_length(const SampleGraph& graph) {
  double sum = 0;
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) sum += graph.length(e);
  return sum / static_cast<double>(graph.edges.size());
}

TEST(Costs, AreLengthsTimesTheWeightsOfTheRock) {
  const SampleGraph graph = complete_graph(15);
  Geology geology;
  geology.beds = {{.point = {0, 5, 0}}};
  geology.faults = {{.point = {3, 0, 0}, .azimuth = 0, .width = 20}};
  geology.permeable = {{.center = {0, 0, 10}, .radius = 30, .strength = 0.8}};
  KarstOptions options;
  options.cost = {.bed = 1.5,
                  .bed_reach = 25,
                  .fracture = 2.5,
                  .permeability = 0.7,
                  .heterogeneity = 0,
                  .shortness = 0.4};
  const Rock rock(geology, 1);
  const std::vector<double> costs = edge_costs(graph, rock, options);
  const auto falloff = [](double d, double reach) {
    return d < reach ? std::pow(1 - d * d / (reach * reach), 3) : 0;
  };
  const double mean = mean_length(graph);
  for (size_t e = 0; e < costs.size(); ++e) {
    const Vec3d a = graph.points[static_cast<size_t>(graph.edges[e][0])];
    const Vec3d b = graph.points[static_cast<size_t>(graph.edges[e][1])];
    const Vec3d middle = (a + b) * 0.5, along = (b - a).normalized();
    // A vertical fault that strikes to the north: its normal is the x axis.
    const double alignment = falloff(std::fabs(middle.x - 3), 20) * (1 - along.x * along.x);
    const double permeability = 0.8 * falloff((middle - Vec3d(0, 0, 10)).length(), 30);
    const double factor = 1 + 1.5 * (1 - falloff(std::fabs(middle.y - 5), 25)) +
                          2.5 * (1 - alignment) + 0.7 * (1 - permeability);
    const double length = (b - a).length();
    EXPECT_NEAR(costs[e], length * std::pow(length / mean, 0.4) * factor, 1e-9 * costs[e]);
  }
}

TEST(Costs, HeterogeneityIsLognormal) {
  const SampleGraph graph = complete_graph(60);
  const Geology geology;
  const Rock rock(geology, 1);
  KarstOptions even, uneven;
  even.cost.heterogeneity = 0;
  uneven.cost.heterogeneity = 0.3;
  const std::vector<double> a = edge_costs(graph, rock, even), b = edge_costs(graph, rock, uneven);
  double sum = 0, squares = 0;
  for (size_t e = 0; e < a.size(); ++e) {
    const double logarithm = std::log(b[e] / a[e]);
    sum += logarithm;
    squares += logarithm * logarithm;
  }
  const auto count = static_cast<double>(a.size());
  // Four standard errors.
  EXPECT_NEAR(sum / count, 0, 4 * 0.3 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.3, 4 * 0.3 / std::sqrt(2 * count));
}

TEST(Costs, DependOnTheDirectionAboveTheWaterTableAndOnTheDepthBelow) {
  SampleGraph graph = complete_graph(12);
  Geology geology;
  geology.water_tables = {{.point = {0, 4, 0}}};
  const Rock rock(geology, 1);
  KarstOptions options;
  options.cost.vadose = 3;
  options.cost.phreatic = 1.7;
  options.cost.table_reach = 30;
  graph.cost = edge_costs(graph, rock, options);
  const FlowCost cost(graph, rock, options.cost);
  for (int from = 0; from < graph.size(); ++from)
    for (int i = graph.first[static_cast<size_t>(from)];
         i < graph.first[static_cast<size_t>(from) + 1]; ++i) {
      const Arc& arc = graph.arcs[static_cast<size_t>(i)];
      const Vec3d a = graph.points[static_cast<size_t>(from)];
      const Vec3d b = graph.points[static_cast<size_t>(arc.to)];
      const double base = graph.cost[static_cast<size_t>(arc.edge)];
      const double rise = (b.y - a.y) / (b - a).length();
      EXPECT_NEAR(cost.vadose(from, arc), base * (1 + 1.5 * (1 + rise)), 1e-9 * base);
      const double above = 0.5 * (a.y + b.y) - 4, ratio = above / 30;
      const double near = std::fabs(ratio) < 1 ? std::pow(1 - ratio * ratio, 3) : 0;
      const double weight = 1.7 * (1 - near) * (above > 0 ? 10 : 1);
      EXPECT_NEAR(cost.phreatic(0, from, arc), base * (1 + weight), 1e-9 * base);
    }
}

// With costs that are lengths, the way between two points is the leg between them.
TEST(Skeleton, HasTheEdgesOfTheGammaGraph) {
  SampleGraph graph = complete_graph(14);
  const Geology geology;
  const Rock rock(geology, 1);
  KarstOptions options;
  options.cost = {.vadose = 0, .phreatic = 0, .heterogeneity = 0, .shortness = 0};
  graph.cost = edge_costs(graph, rock, options);
  const FlowCost cost(graph, rock, options.cost);
  std::vector<int> points;
  for (int i = 0; i < graph.size(); ++i) points.push_back(i);
  size_t before = 0;
  for (const double gamma : {2.0, 1.5, 1.1}) {
    Plan plan(graph);
    add_skeleton(cost, points, gamma, plan);
    const auto power = [&](size_t a, size_t b) {
      return std::pow((graph.points[a] - graph.points[b]).length(), gamma);
    };
    size_t kept = 0;
    for (size_t e = 0; e < graph.edges.size(); ++e) {
      const auto a = static_cast<size_t>(graph.edges[e][0]);
      const auto b = static_cast<size_t>(graph.edges[e][1]);
      bool pruned = false;
      for (size_t k = 0; k < graph.points.size(); ++k)
        pruned |= k != a && k != b && power(a, k) + power(k, b) < power(a, b);
      EXPECT_EQ(plan.has(static_cast<int>(e)), !pruned) << gamma << ", " << a << " to " << b;
      kept += pruned ? 0 : 1;
    }
    EXPECT_GT(kept, before) << "a smaller gamma keeps more ways";
    before = kept;
  }
  EXPECT_LT(before, graph.edges.size());
}

}  // namespace
}  // namespace vug::karst
