// SPDX-License-Identifier: Apache-2.0
#include <vug/karst/assemble.h>
#include <vug/karst/contradictions.h>
#include <vug/karst/generate.h>
#include <vug/karst/growth.h>
#include <vug/karst/separation.h>
#include <vug/karst/skeleton.h>

#include <numeric>

namespace vug::karst {
namespace {

std::vector<int> range(int begin, int end) {
  std::vector<int> indices(static_cast<size_t>(end - begin));
  std::iota(indices.begin(), indices.end(), begin);
  return indices;
}

}  // namespace

network::Network generate(const Geology& geology, const KarstOptions& options) {
  require_valid(geology);
  require_valid(options);
  const Rock rock(geology, options.seed);
  const KeyPoints keys = key_points(rock, options);
  require_no_contradiction(keys, rock);
  const Samples samples = draw_samples(rock, keys, options);
  SampleGraph graph = build_graph(samples.points, options.samples.neighbours, samples.joint_edges);
  graph.cost = edge_costs(graph, rock, options, samples.joint_edges);
  graph = separated(std::move(graph), samples.random, options.samples.separation);
  const FlowCost cost(graph, rock, options.cost);
  Plan plan(graph);
  add_flow(cost, keys, samples, options, plan);
  if (options.growth.gamma > 0) {
    std::vector<int> ends = range(samples.sinks, samples.entrances);
    const std::vector<int> ways = range(samples.waypoints, samples.random);
    ends.insert(ends.end(), ways.begin(), ways.end());
    add_skeleton(cost, ends, options.growth.gamma, plan);
  }
  // Unused springs and sinks, waypoints and entrances join what exists.
  connect(cost, range(samples.sinks, samples.random), plan);
  grow(cost, options, plan);
  return assemble(plan, keys, samples, rock, options);
}

}  // namespace vug::karst
