// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/passages/water/flood.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>

namespace vug::passages {
namespace {

/// A node that can be visited next, ordered by level, distance to the outlet and index.
using Candidate = std::tuple<double, double, int, int>;  // The last is the node towards which.

/// Nodes with this flag; without any, the extreme end of a passage. `sign`: 1 for the lowest.
std::vector<int> flagged_or_extreme(const FloorPlan& plan, const network::Network& network,
                                    bool network::StationFlags::*flag, double sign) {
  std::vector<int> out;
  for (size_t i = 0; i < plan.nodes.size(); ++i)
    if (const int station = plan.nodes[i].station;
        station >= 0 && network.stations[static_cast<size_t>(station)].flags.*flag)
      out.push_back(static_cast<int>(i));
  if (!out.empty() || plan.nodes.empty()) return out;
  const std::vector<std::vector<int>> adjacent = neighbours(plan);
  int best = -1;
  const auto consider = [&](bool ends) {
    for (size_t i = 0; i < plan.nodes.size(); ++i) {
      if (ends && adjacent[i].size() != 1) continue;
      if (best < 0 ||
          sign * plan.nodes[i].floor < sign * plan.nodes[static_cast<size_t>(best)].floor)
        best = static_cast<int>(i);
    }
  };
  consider(true);
  if (best < 0) consider(false);
  return {best};
}

}  // namespace

Flood flood(const FloorPlan& plan, const std::vector<double>& bed,
            const std::vector<int>& outlets) {
  const std::vector<std::vector<int>> adjacent = neighbours(plan);
  const size_t count = plan.nodes.size();
  Flood out{std::vector<double>(count, kInfinity), std::vector<int>(count, -1), {}};
  std::vector<char> visited(count, 0);
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
  const auto spread = [&] {
    while (!open.empty()) {
      const auto [level, distance, node, towards] = open.top();
      open.pop();
      const auto i = static_cast<size_t>(node);
      if (visited[i]) continue;
      visited[i] = 1;
      out.level[i] = level;
      out.towards[i] = towards;
      out.order.push_back(node);
      for (const int next : adjacent[i])
        if (const auto k = static_cast<size_t>(next); !visited[k])
          open.emplace(std::max(level, bed[k]), distance + plan_distance(plan, node, next), next,
                       node);
    }
  };
  for (const int outlet : outlets) open.emplace(bed[static_cast<size_t>(outlet)], 0.0, outlet, -1);
  spread();
  std::vector<int> upwards(count);
  std::iota(upwards.begin(), upwards.end(), 0);
  std::sort(upwards.begin(), upwards.end(), [&](int a, int b) {
    const double x = bed[static_cast<size_t>(a)], y = bed[static_cast<size_t>(b)];
    return x != y ? x < y : a < b;
  });
  for (const int lowest : upwards) {
    if (visited[static_cast<size_t>(lowest)]) continue;
    open.emplace(bed[static_cast<size_t>(lowest)], 0.0, lowest, -1);
    spread();
  }
  return out;
}

std::vector<int> nodes_at(const FloorPlan& plan, const network::Network& network,
                          const std::vector<int>& stations) {
  std::vector<int> out;
  for (const int station : stations) {
    const network::Station& wanted = network.stations[static_cast<size_t>(station)];
    const auto at = std::find_if(plan.nodes.begin(), plan.nodes.end(), [&](const FloorNode& node) {
      return node.station >= 0 &&
             network.stations[static_cast<size_t>(node.station)].position == wanted.position;
    });
    if (at == plan.nodes.end())
      throw Error(ErrorCode::bad_input,
                  fmt::format("no passage leads to the station '{}'", wanted.name), {},
                  "name a station with a leg underground");
    out.push_back(static_cast<int>(at - plan.nodes.begin()));
  }
  return out;
}

std::vector<int> default_outlets(const FloorPlan& plan, const network::Network& network) {
  return flagged_or_extreme(plan, network, &network::StationFlags::spring, 1);
}

std::vector<int> default_sources(const FloorPlan& plan, const network::Network& network) {
  return flagged_or_extreme(plan, network, &network::StationFlags::sink, -1);
}

}  // namespace vug::passages
