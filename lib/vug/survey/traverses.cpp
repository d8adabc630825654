// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/traverses.h>

#include <algorithm>

namespace vug::survey {
namespace {

size_t at(int i) { return static_cast<size_t>(i); }

/// Removes points with one edge until none remain; `degrees` and `removed` are updated.
std::vector<DeadEnd> peel(const LegGraph& graph, std::vector<int>& degrees,
                          std::vector<bool>& removed) {
  std::vector<DeadEnd> all;
  for (int start = 0; start < graph.points; ++start) {
    for (int point = start; degrees[at(point)] == 1 && !graph.positions[at(point)];) {
      const auto edges = graph.edges_of[at(point)];
      const int edge =
          *std::find_if(edges.begin(), edges.end(), [&](int each) { return !removed[at(each)]; });
      all.push_back({edge, point});
      removed[at(edge)] = true;
      degrees[at(point)] = 0;
      point = graph.across(edge, point);
      --degrees[at(point)];
    }
  }
  return all;
}

/// Follows the chain that starts at a junction with an edge.
TraverseChain follow(const LegGraph& graph, const std::vector<bool>& junction,
                     std::vector<bool>& used, int from, int edge) {
  TraverseChain chain;
  chain.from = chain.to = from;
  for (;;) {
    used[at(edge)] = true;
    chain.edges.push_back(edge);
    chain.forwards.push_back(graph.edges[at(edge)].a == chain.to);
    chain.to = graph.across(edge, chain.to);
    if (junction[at(chain.to)]) return chain;
    const auto edges = graph.edges_of[at(chain.to)];
    edge = *std::find_if(edges.begin(), edges.end(), [&](int each) { return !used[at(each)]; });
  }
}

/// Marks the chains without which the graph falls apart, by a depth-first search for the lowest
/// point that the chains below each one reach [@tarjan1974]. All fixed points are one.
void mark_bridges(const LegGraph& graph, std::vector<TraverseChain>& chains) {
  const auto node = [&](int point) { return graph.positions[at(point)] ? graph.points : point; };
  std::vector<std::vector<int>> chains_of(at(graph.points) + 1);
  for (size_t i = 0; i < chains.size(); ++i) {
    chains_of[at(node(chains[i].from))].push_back(static_cast<int>(i));
    chains_of[at(node(chains[i].to))].push_back(static_cast<int>(i));
  }
  struct Visit {
    int node, chain;
    size_t next;
  };
  std::vector<int> order(chains_of.size(), -1), low(chains_of.size(), -1);
  int count = 0;
  std::vector<Visit> stack = {{graph.points, -1, 0}};
  order.back() = low.back() = count++;
  while (!stack.empty()) {
    Visit& top = stack.back();
    if (top.next == chains_of[at(top.node)].size()) {
      const Visit done = top;
      stack.pop_back();
      if (stack.empty()) break;
      int& above = low[at(stack.back().node)];
      above = std::min(above, low[at(done.node)]);
      chains[at(done.chain)].bridge = low[at(done.node)] == order[at(done.node)];
      continue;
    }
    const int chain = chains_of[at(top.node)][top.next++];
    if (chain == top.chain) continue;
    const TraverseChain& link = chains[at(chain)];
    const int next = node(link.from) == top.node ? node(link.to) : node(link.from);
    if (order[at(next)] >= 0) {
      low[at(top.node)] = std::min(low[at(top.node)], order[at(next)]);
      continue;
    }
    order[at(next)] = low[at(next)] = count++;
    stack.push_back({next, chain, 0});
  }
}

}  // namespace

Traverses find_traverses(const LegGraph& graph) {
  std::vector<int> degrees;
  degrees.reserve(at(graph.points));
  for (int point = 0; point < graph.points; ++point)
    degrees.push_back(static_cast<int>(graph.edges_of[at(point)].size()));
  std::vector<bool> used(graph.edges.size(), false);
  Traverses out;
  out.dead_ends = peel(graph, degrees, used);
  std::vector<bool> junction;
  for (int point = 0; point < graph.points; ++point)
    junction.push_back(graph.positions[at(point)] || degrees[at(point)] != 2);
  for (int point = 0; point < graph.points; ++point) {
    if (!junction[at(point)]) continue;
    for (const int edge : graph.edges_of[at(point)])
      if (!used[at(edge)]) out.chains.push_back(follow(graph, junction, used, point, edge));
  }
  mark_bridges(graph, out.chains);
  return out;
}

}  // namespace vug::survey
