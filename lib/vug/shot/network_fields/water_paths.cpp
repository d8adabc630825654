// SPDX-License-Identifier: Apache-2.0
// Tubes along the ways of the water of drips.
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/passages/lines/centreline.h>
#include <vug/shot/drips_plan.h>
#include <vug/shot/networks.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::shot {
namespace {

enum class Paths { all, films, falls };

struct WaterPaths {
  DripsPtr of;
  Paths only = Paths::all;
  static constexpr double kWidest = 4;   // Times the radius.
  static constexpr double kMinute = 60;  // Seconds between drops at which the radius is exact.
  static constexpr double kClasses = 4;  // Classes of radii in a factor of 2.

  double radius = 0.005;
  double by_discharge = 0;
  double share = 1;
  int seed = 1;

  static void describe(Schema<WaterPaths>& s) {
    s.doc(
         "Tubes along the ways of the water of named drips: films on roofs, walls and floors, and "
         "falls of drops. They show the graph, and as the distance of the mask `near` they place "
         "wet films and stains.")
        .param("of", &WaterPaths::of, {.doc = "the drips", .required = true})
        .choice("only", &WaterPaths::only,
                {{"all", Paths::all}, {"films", Paths::films}, {"falls", Paths::falls}},
                "which ways")
        .param("radius", &WaterPaths::radius, positive_length("radius of the tubes"))
        .param("by_discharge", &WaterPaths::by_discharge,
               {.doc = "exponent by which the radius follows the discharge: ways with a drop a "
                       "minute have `radius`, others at most 4 times it; 0: all are equal, 1/3: as "
                       "the thickness of a film",
                .min = 0,
                .max = 1})
        .param("share", &WaterPaths::share,
               {.doc = "share of the drips whose ways are included, with all places to which their "
                       "water runs: e.g. those whose water carries iron",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("seed", &WaterPaths::seed, {.doc = "random seed of this choice"});
  }
  bool shows(drips::EdgeKind kind) const {
    return only == Paths::all || (only == Paths::falls) == (kind == drips::EdgeKind::fall);
  }
};

/// Whether the water at each node comes from a drip of the share. Edges are in the order of the
/// flow.
std::vector<bool> chosen_nodes(const WaterPaths& p) {
  const drips::Graph& graph = p.of->graph();
  const RandomKey key = RandomKey(static_cast<uint64_t>(p.seed)).at("water paths");
  std::vector<bool> chosen;
  for (const drips::Node& node : graph.nodes)
    chosen.push_back(node.kind == drips::NodeKind::seep &&
                     RandomStream(key.at(static_cast<uint64_t>(node.id))).uniform() < p.share);
  for (const drips::Edge& edge : graph.edges)
    if (chosen[static_cast<size_t>(edge.from)]) chosen[static_cast<size_t>(edge.to)] = true;
  return chosen;
}

/// The class of a way: its radius is `radius` times 2^(class / kClasses).
int class_of(const WaterPaths& p, double discharge) {
  if (!(p.by_discharge > 0 && discharge > 0)) return 0;
  const double drops = discharge / p.of->graph().drop * WaterPaths::kMinute;
  const double factor = std::min(maths::pow(drops, p.by_discharge), WaterPaths::kWidest);
  return static_cast<int>(std::floor(WaterPaths::kClasses * maths::log(factor) / maths::log(2.0)));
}

/// The ways of each class.
std::map<int, std::vector<passages::AxisLine>> lines(const WaterPaths& p) {
  const std::vector<bool> chosen = chosen_nodes(p);
  std::map<int, std::vector<passages::AxisLine>> out;
  for (const drips::Edge& edge : p.of->graph().edges) {
    if (!p.shows(edge.kind) || !chosen[static_cast<size_t>(edge.from)]) continue;
    for (size_t i = 1; i < edge.path.size(); ++i)
      if (edge.path[i] != edge.path[i - 1])
        out[class_of(p, edge.water.discharge)].push_back(
            {.from = edge.path[i - 1], .to = edge.path[i]});
  }
  return out;
}

field::Field tubes(const WaterPaths& p) {
  const drips::GraphOptions options = p.of->options().graph;
  const field::Traits traits{1, field::Exactness::eikonal,
                             grown(Box3d(options.from, options.to),
                                   p.radius * (p.by_discharge > 0 ? WaterPaths::kWidest : 1)),
                             1};
  return field::deferred(
      traits, {"finding drips", drips::graph_memory(options)},
      [](const WaterPaths& paths) {
        std::vector<field::Field> classes;
        for (auto& [number, ways] : lines(paths))
          classes.push_back(passages::centreline(
              std::move(ways), paths.radius * maths::pow(2.0, number / WaterPaths::kClasses)));
        return classes.empty() ? field::empty() : field::unite(std::move(classes));
      },
      p);
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(water_paths) {
  return field::field_kind<WaterPaths>("water_paths", "detail", tubes);
}
