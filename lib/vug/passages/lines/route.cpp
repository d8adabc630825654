// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/passages/curves/axis.h>
#include <vug/passages/lines/route.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace vug::passages {
namespace {

struct AxisEdge {
  size_t to;
  double length;
};

/// The points of all axes as a graph.
struct AxisGraph {
  std::vector<CurvePoint> points;
  std::vector<std::vector<AxisEdge>> edges;

  void join(size_t a, size_t b) {
    const double length = (points[a].position - points[b].position).length();
    edges[a].push_back({b, length});
    edges[b].push_back({a, length});
  }
};

/// The point for which `distance` is least, of those for which it is finite.
size_t least_of(const AxisGraph& graph, const std::function<double(size_t)>& distance) {
  size_t best = graph.points.size();
  double least = kInfinity;
  for (size_t i = 0; i < graph.points.size(); ++i) {
    const double d = distance(i);
    if (d < least) {
      least = d;
      best = i;
    }
  }
  return best;
}

/// Joins the end of a passage that meets another one to the nearest point of an axis that goes on.
void join_end(AxisGraph& graph, const std::vector<bool>& is_end, size_t end) {
  const size_t other = least_of(graph, [&](size_t i) {
    return is_end[i] ? kInfinity : (graph.points[i].position - graph.points[end].position).length();
  });
  if (other < graph.points.size()) graph.join(end, other);
}

AxisGraph graph_of(const network::Network& network, const PassageOptions& options) {
  const std::vector<Chain> all = chains(network);
  const std::vector<Curve> curves = axes(network, all, options);
  AxisGraph graph;
  std::vector<size_t> meeting;
  for (size_t k = 0; k < curves.size(); ++k) {
    if (curves[k].size() < 2) continue;
    const size_t first = graph.points.size();
    graph.points.insert(graph.points.end(), curves[k].begin(), curves[k].end());
    graph.edges.resize(graph.points.size());
    for (size_t i = first; i + 1 < graph.points.size(); ++i) graph.join(i, i + 1);
    if (all[k].start_meets) meeting.push_back(first);
    if (all[k].end_meets) meeting.push_back(graph.points.size() - 1);
  }
  std::vector<bool> is_end(graph.points.size());
  for (const size_t end : meeting) is_end[end] = true;
  for (const size_t end : meeting) join_end(graph, is_end, end);
  return graph;
}

/// The point of the axes that belongs to a station, else the nearest one.
size_t node_of(const AxisGraph& graph, const network::Network& network, int station) {
  const Vec3d at = network.stations[static_cast<size_t>(station)].position;
  const auto distance = [&](size_t i) { return (graph.points[i].position - at).length(); };
  const size_t own = least_of(graph, [&](size_t i) {
    const int here = graph.points[i].station;
    const bool same = here >= 0 && network.stations[static_cast<size_t>(here)].position == at;
    return same ? distance(i) : kInfinity;
  });
  return own < graph.points.size() ? own : least_of(graph, distance);
}

/// The points on the shortest way; ties are broken by the index of the points. Empty: no way.
std::vector<size_t> shortest_way(const AxisGraph& graph, size_t from, size_t to) {
  std::vector<double> best(graph.points.size(), kInfinity);
  std::vector<size_t> before(graph.points.size(), graph.points.size());
  std::priority_queue<std::pair<double, size_t>, std::vector<std::pair<double, size_t>>,
                      std::greater<>>
      open;
  best[from] = 0;
  open.emplace(0.0, from);
  while (!open.empty()) {
    const auto [length, node] = open.top();
    open.pop();
    if (length > best[node]) continue;
    if (node == to) break;
    for (const AxisEdge& edge : graph.edges[node]) {
      if (length + edge.length >= best[edge.to]) continue;
      best[edge.to] = length + edge.length;
      before[edge.to] = node;
      open.emplace(best[edge.to], edge.to);
    }
  }
  std::vector<size_t> way;
  if (best[to] == kInfinity) return way;
  for (size_t node = to; node != from; node = before[node]) way.push_back(node);
  way.push_back(from);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace

Route::Route(const network::Network& network, const PassageOptions& options, int from, int to) {
  network::require_valid(network);
  const AxisGraph graph = graph_of(network, options);
  if (graph.points.empty())
    throw Error(ErrorCode::bad_input, "the network has no passages", {},
                "give it legs with a length that do not run over the surface");
  const std::vector<size_t> way =
      shortest_way(graph, node_of(graph, network, from), node_of(graph, network, to));
  const auto name = [&](int i) { return network.stations[static_cast<size_t>(i)].name; };
  if (way.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("no passage leads from '{}' to '{}'", name(from), name(to)), {},
                "choose two stations of one cave; legs over the surface are not passages");
  for (const size_t i : way) {
    const CurvePoint& p = graph.points[i];
    const double step = points_.empty() ? 0 : (p.position - points_.back()).length();
    if (!points_.empty() && !(step > 0)) continue;
    along_.push_back(points_.empty() ? 0 : along_.back() + step);
    points_.push_back(p.position);
    sizes_.push_back(0.5 * p.smaller());
  }
}

size_t Route::piece(double s) const {
  const auto after = std::upper_bound(along_.begin(), along_.end(), s);
  const auto i = static_cast<size_t>(std::max<std::ptrdiff_t>(after - along_.begin() - 1, 0));
  return std::min(i, points_.size() - 2);
}

Vec3d Route::on_axes(double s) const {
  const size_t i = piece(s);
  return points_[i] +
         (points_[i + 1] - points_[i]) * ((s - along_[i]) / (along_[i + 1] - along_[i]));
}

double Route::half_size(double s) const {
  const size_t i = piece(s);
  const double t = (s - along_[i]) / (along_[i + 1] - along_[i]);
  return sizes_[i] + (sizes_[i + 1] - sizes_[i]) * std::clamp(t, 0.0, 1.0);
}

Vec3d Route::point(double s) const {
  if (points_.size() < 2) return points_[0];
  if (!(s > 0 && s < length())) return on_axes(s);
  constexpr int kSamples = 16;
  const double reach = std::min({half_size(s), s, length() - s});
  Vec3d sum(0.0);
  for (int i = 0; i < kSamples; ++i) sum += on_axes(s + reach * ((2 * i + 1.0) / kSamples - 1));
  return sum / kSamples;
}

}  // namespace vug::passages
