// SPDX-License-Identifier: Apache-2.0
#include <vug/karst/plan.h>

#include <algorithm>

namespace vug::karst {

void Plan::set(int edge, const Passage& passage) {
  if (!has(edge))
    for (const int end : graph_.edges[static_cast<size_t>(edge)])
      ++degree_[static_cast<size_t>(end)];
  passages_[static_cast<size_t>(edge)] = passage;
}

void Plan::remove(int edge) {
  if (!has(edge)) return;
  for (const int end : graph_.edges[static_cast<size_t>(edge)]) --degree_[static_cast<size_t>(end)];
  passages_[static_cast<size_t>(edge)] = {};
}

int Plan::other_end(int edge, int point) const {
  const auto& [a, b] = graph_.edges[static_cast<size_t>(edge)];
  return a == point ? b : a;
}

int Plan::edge_between(int a, int b) const {
  const auto begin = graph_.arcs.begin() + graph_.first[static_cast<size_t>(a)];
  const auto end = graph_.arcs.begin() + graph_.first[static_cast<size_t>(a) + 1];
  const auto found =
      std::lower_bound(begin, end, b, [](const Arc& arc, int to) { return arc.to < to; });
  return found != end && found->to == b ? found->edge : -1;
}

std::vector<int> Plan::points() const {
  std::vector<int> result;
  for (int i = 0; i < graph_.size(); ++i)
    if (contains(i)) result.push_back(i);
  return result;
}

network::Network Plan::network() const {
  network::Network network;
  std::vector<int> station(graph_.points.size(), -1);
  for (const int point : points()) {
    station[static_cast<size_t>(point)] = static_cast<int>(network.stations.size());
    network.stations.push_back({.position = graph_.points[static_cast<size_t>(point)]});
  }
  for (size_t e = 0; e < passages_.size(); ++e) {
    const Passage& passage = passages_[e];
    if (passage.from < 0) continue;
    const int to = other_end(static_cast<int>(e), passage.from);
    network.legs.push_back({.from = station[static_cast<size_t>(passage.from)],
                            .to = station[static_cast<size_t>(to)],
                            .stage = passage.stage,
                            .discharge = passage.discharge,
                            .tier = passage.tier});
  }
  return network;
}

}  // namespace vug::karst
