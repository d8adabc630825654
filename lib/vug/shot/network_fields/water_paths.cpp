// SPDX-License-Identifier: Apache-2.0
// Tubes along the ways of the water of drips.
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/passages/lines/centreline.h>
#include <vug/shot/drips_plan.h>
#include <vug/shot/networks.h>

namespace vug::shot {
namespace {

enum class Paths { all, films, falls };

struct WaterPaths {
  DripsPtr of;
  Paths only = Paths::all;
  double radius = 0.005;

  static void describe(Schema<WaterPaths>& s) {
    s.doc(
         "Tubes along the ways of the water of named drips: films on roofs, walls and floors, and "
         "falls of drops. They show the graph, and as a distance they are a mask for stains.")
        .param("of", &WaterPaths::of, {.doc = "the drips", .required = true})
        .choice("only", &WaterPaths::only,
                {{"all", Paths::all}, {"films", Paths::films}, {"falls", Paths::falls}},
                "which ways")
        .param("radius", &WaterPaths::radius, positive_length("radius of the tubes"));
  }
  bool shows(drips::EdgeKind kind) const {
    return only == Paths::all || (only == Paths::falls) == (kind == drips::EdgeKind::fall);
  }
};

std::vector<passages::AxisLine> lines(const WaterPaths& p) {
  std::vector<passages::AxisLine> out;
  for (const drips::Edge& edge : p.of->graph().edges) {
    if (!p.shows(edge.kind)) continue;
    for (size_t i = 1; i < edge.path.size(); ++i)
      if (edge.path[i] != edge.path[i - 1])
        out.push_back({.from = edge.path[i - 1], .to = edge.path[i]});
  }
  return out;
}

field::Field tubes(const WaterPaths& p) {
  const drips::GraphOptions options = p.of->options().graph;
  const field::Traits traits{1, field::Exactness::eikonal,
                             grown(Box3d(options.from, options.to), p.radius), 1};
  return field::deferred(
      traits, "finding drips",
      [p] {
        std::vector<passages::AxisLine> ways = lines(p);
        return ways.empty() ? field::empty() : passages::centreline(std::move(ways), p.radius);
      },
      drips::graph_memory(options));
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(water_paths) {
  return field::field_kind<WaterPaths>("water_paths", "detail", tubes);
}
