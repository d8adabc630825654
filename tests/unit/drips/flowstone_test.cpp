// SPDX-License-Identifier: Apache-2.0
// Flowstone lies along the films of walls and floors, and consists of the calcium that they lost.
#include <vug/drips/dripstone.h>
#include <vug/drips/film_network.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "rooms.h"

namespace vug::drips {
namespace {

Graph wet_cave(const field::Field& rock, double oldest) {
  GraphOptions o = graph_options(3);
  o.density = 1;
  o.oldest = oldest;
  return build_graph(rock, o);
}

bool is_wet(const Edge& edge) {
  return edge.kind == EdgeKind::wall_film || edge.kind == EdgeKind::floor_film;
}

/// The part of a film that lies above the pool at its end.
std::vector<Vec3d> above_water(const Graph& graph, const Edge& edge) {
  const Node& end = graph.nodes[static_cast<size_t>(edge.to)];
  std::vector<Vec3d> path;
  for (const Vec3d& p : edge.path)
    if (end.kind != NodeKind::pool || p.y > end.level) path.push_back(p);
  return path;
}

TEST(Flowstone, ConsistsOfTheCalciumThatItsFilmsLost) {
  // Young: no layer is as thick as the limit.
  const Graph graph = wet_cave(cave(), 1000);
  double lost = 0;
  for (const Edge& edge : graph.edges) {
    const std::vector<Vec3d> path = above_water(graph, edge);
    if (is_wet(edge) && path.size() > 1)
      lost += deposited_volume(edge.water, edge.water.calcium,
                               after_film(edge.water, path, film_width(edge.kind)).calcium);
  }
  double laid = 0;
  for (const field::Deposit& layer : flowstone_of(graph, {}, {.share = 1}))
    laid +=
        0.5 * field::kSectionShare *
        (layer.half_width_from * layer.thickness_from + layer.half_width_to * layer.thickness_to) *
        (layer.to - layer.from).length();
  EXPECT_NEAR(laid, lost, 0.1 * lost);
}

TEST(Flowstone, LiesOnTheRockAndNotUnderWater) {
  const field::Field rock = cave();
  const Graph graph = wet_cave(rock, 20000);
  std::map<int64_t, double> levels;
  const std::vector<field::Deposit> layers = flowstone_of(graph, {}, {.share = 1});
  EXPECT_GT(layers.size(), 100u);
  for (const field::Deposit& layer : layers) {
    EXPECT_LT(std::fabs(rock.value(layer.from)), 0.01);
    // A film ends in a point of another one that is at most a tenth of its width higher.
    EXPECT_LT(layer.to.y, layer.from.y + 0.1 * film_width(EdgeKind::floor_film));
    EXPECT_GT(layer.half_width_from, 0.049);
    EXPECT_LE(layer.thickness_from, 0.14);
  }
  for (const Node& pool : graph.nodes) {
    if (pool.kind != NodeKind::pool) continue;
    for (const field::Deposit& layer : layers) {
      EXPECT_FALSE((layer.from - pool.position).length() < 0.05 && layer.to.y < pool.level - 0.05);
    }
  }
}

TEST(Flowstone, ContinuesWhereFilmsMeet) {
  const Graph graph = wet_cave(cave(), 20000);
  std::set<int64_t> half, all;
  for (const field::Deposit& layer : flowstone_of(graph, {}, {.share = 0.5}))
    half.insert(layer.drip);
  for (const field::Deposit& layer : flowstone_of(graph, {}, {.share = 1})) all.insert(layer.drip);
  EXPECT_TRUE(flowstone_of(graph, {}, {.share = 0}).empty());
  EXPECT_GT(half.size(), all.size() / 5);
  EXPECT_LT(half.size(), all.size());
  for (const int64_t drip : half) EXPECT_TRUE(all.contains(drip));
}

TEST(Flowstone, WithoutItFormsDoNotDependOnTheFilmsOverFloors) {
  const field::Field rock = cave(8);
  GraphOptions o = graph_options(4);
  o.density = 1;
  o.oldest = 20000;
  const Graph whole = build_graph(rock, o);
  o.over_floors = false;
  const Graph part = build_graph(rock, o);
  EXPECT_LT(part.edges.size(), whole.edges.size());
  DripstoneOptions options;
  options.flowstone.share = 0;
  const Dripstone expected = grow_dripstone(rock, whole, options),
                  found = grow_dripstone(rock, part, options);
  ASSERT_GT(expected.forms.size(), 100);
  ASSERT_EQ(found.forms.size(), expected.forms.size());
  for (size_t i = 0; i < found.forms.size(); ++i) {
    EXPECT_EQ(found.forms[i].drip, expected.forms[i].drip);
    EXPECT_EQ(found.forms[i].top, expected.forms[i].top);
    EXPECT_EQ(found.forms[i].radius, expected.forms[i].radius);
  }
  RandomStream random(RandomKey(1).at("floors"));
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(-4, 4), y = random.uniform(-2.2, 1.5);
    const Vec3d p(x, y, random.uniform(-3, 3));
    EXPECT_EQ(found.solids.value(p), expected.solids.value(p));
  }
  // Skirts remain. Only those at landings that a film from elsewhere reaches differ: they have lost
  // its water.
  std::set<int64_t> reached;
  for (const Edge& edge : whole.edges)
    if (edge.kind == EdgeKind::floor_film)
      reached.insert(whole.nodes[static_cast<size_t>(edge.to)].id);
  ASSERT_EQ(found.layers.size(), expected.layers.size());
  int same = 0;
  for (size_t i = 0; i < found.layers.size(); ++i) {
    const field::Deposit &own = found.layers[i], &all = expected.layers[i];
    EXPECT_EQ(own.drip, all.drip);
    if (reached.contains(own.drip)) {
      EXPECT_LE(own.half_width_from, all.half_width_from);
      EXPECT_LE(own.thickness_from, all.thickness_from);
    } else {
      EXPECT_EQ(own.half_width_from, all.half_width_from);
      EXPECT_EQ(own.thickness_from, all.thickness_from);
      ++same;
    }
  }
  EXPECT_GT(same, 20);
}

}  // namespace
}  // namespace vug::drips
