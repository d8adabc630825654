// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/leg_graph.h>

#include <vug/base/disjoint_sets.h>

#include <fmt/format.h>

namespace vug::survey {
namespace {

size_t as_index(int i) { return static_cast<size_t>(i); }

/// For each station the first of the stations that are equated to it.
std::vector<int> first_equals(const Observations& observations) {
  DisjointSets<int> sets(observations.stations.size());
  for (const Equate& each : observations.equates) sets.join(each.a, each.b);
  std::vector<int> first;
  first.reserve(observations.stations.size());
  for (size_t i = 0; i < observations.stations.size(); ++i)
    first.push_back(sets.root(static_cast<int>(i)));
  return first;
}

int add_point(LegGraph& graph, int station) {
  graph.station_of.push_back(station);
  graph.positions.emplace_back();
  return graph.points++;
}

void apply_fix(LegGraph& graph, const Fix& fix, const Observations& observations,
               Diagnostics& warnings) {
  const int point = graph.point_of[as_index(fix.station)];
  if (fix.covariance) {
    const int place = add_point(graph, -1);
    graph.positions[as_index(place)] = fix.position;
    graph.edges.push_back({place, point, Vec3d(0), *fix.covariance, -1});
    return;
  }
  std::optional<Vec3d>& position = graph.positions[as_index(point)];
  const std::string& name = observations.stations[as_index(fix.station)].name;
  if (position && (*position - fix.position).length() > 1e-6)
    throw Error(ErrorCode::bad_input, fmt::format("the station '{}' is fixed at two places", name),
                fix.where, "equated stations are one place; remove a fix");
  if (position)
    warnings.warning(fix.where,
                     fmt::format("the station '{}' is fixed again at the same place", name),
                     "remove one of the fixes");
  position = fix.position;
}

/// All points of stations: first the ends of legs, in the order of the legs, with named ones first
/// in each, then the others.
std::vector<int> anchor_candidates(const LegGraph& graph, const Observations& observations) {
  std::vector<int> all;
  all.reserve(2 * graph.edges.size() + as_index(graph.points));
  for (const Edge& edge : graph.edges) {
    if (edge.leg < 0) continue;
    const int first = graph.station_of[as_index(edge.a)];
    const bool anonymous = observations.stations[as_index(first)].anonymous();
    all.push_back(anonymous ? edge.b : edge.a);
    all.push_back(anonymous ? edge.a : edge.b);
  }
  for (int point = 0; point < graph.points; ++point)
    if (graph.station_of[as_index(point)] >= 0) all.push_back(point);
  return all;
}

/// Fixes a point in each component that has none.
void anchor_components(LegGraph& graph, const Observations& observations, Diagnostics& warnings) {
  std::vector<bool> reached(as_index(graph.points), false);
  std::vector<int> open;
  const auto spread = [&](int from) {
    std::vector<int> found;
    open.push_back(from);
    reached[as_index(from)] = true;
    while (!open.empty()) {
      const int point = open.back();
      open.pop_back();
      found.push_back(point);
      for (const int edge : graph.edges_of[as_index(point)]) {
        const int next = graph.across(edge, point);
        if (!reached[as_index(next)]) open.push_back(next);
        reached[as_index(next)] = true;
      }
    }
    return found;
  };
  for (int point = 0; point < graph.points; ++point)
    if (graph.positions[as_index(point)] && !reached[as_index(point)]) spread(point);
  bool any_fix = !observations.fixes.empty();
  for (const int point : anchor_candidates(graph, observations)) {
    if (reached[as_index(point)]) continue;
    const Station& station = observations.stations[as_index(graph.station_of[as_index(point)])];
    graph.positions[as_index(point)] = Vec3d(0);
    std::vector<int> component = spread(point);
    if (any_fix) {
      warnings.warning(station.where,
                       fmt::format("the station '{}' and those connected to it are not connected "
                                   "to a fixed station; they are placed east of the rest",
                                   station.name),
                       "equate one of them to a station of the rest, or fix one of them");
      graph.loose.push_back(std::move(component));
    }
    any_fix = true;
  }
}

/// Metres between the bounding boxes of components.
constexpr double kGap = 10;

}  // namespace

IncidentEdges::IncidentEdges(size_t points, const std::vector<Edge>& edges)
    : starts_(points + 1, 0), edges_(2 * edges.size()) {
  for (const Edge& each : edges)
    for (const int end : {each.a, each.b}) ++starts_[as_index(end) + 1];
  for (size_t i = 0; i < points; ++i) starts_[i + 1] += starts_[i];
  std::vector<size_t> next(starts_.begin(), starts_.end() - 1);
  for (size_t i = 0; i < edges.size(); ++i)
    for (const int end : {edges[i].a, edges[i].b})
      edges_[next[as_index(end)]++] = static_cast<int>(i);
}

void separate_components(LegGraph& graph) {
  std::vector<bool> is_loose(as_index(graph.points), false);
  for (const std::vector<int>& component : graph.loose)
    for (const int point : component) is_loose[as_index(point)] = true;
  const auto position = [&](int point) -> Vec3d& { return *graph.positions[as_index(point)]; };
  Box3d rest;
  for (int point = 0; point < graph.points; ++point)
    if (!is_loose[as_index(point)]) rest.extendBy(position(point));
  for (const std::vector<int>& component : graph.loose) {
    Box3d box;
    for (const int point : component) box.extendBy(position(point));
    const Vec3d shift = Vec3d(rest.max.x + kGap, rest.min.y, rest.min.z) - box.min;
    for (const int point : component) rest.extendBy(position(point) += shift);
  }
}

LegGraph make_leg_graph(const Observations& observations, Diagnostics& warnings) {
  LegGraph graph;
  const std::vector<int> first = first_equals(observations);
  graph.point_of.resize(first.size());
  for (size_t i = 0; i < first.size(); ++i)
    graph.point_of[i] = as_index(first[i]) == i ? add_point(graph, static_cast<int>(i))
                                                : graph.point_of[as_index(first[i])];
  graph.edges.reserve(observations.legs.size());
  for (size_t i = 0; i < observations.legs.size(); ++i) {
    const ObservedLeg& each = observations.legs[i];
    if (each.leg.style == Style::nosurvey) continue;
    graph.edges.push_back({graph.point_of[as_index(each.leg.from)],
                           graph.point_of[as_index(each.leg.to)], each.vector, each.covariance,
                           static_cast<int>(i)});
  }
  for (const Fix& fix : observations.fixes) apply_fix(graph, fix, observations, warnings);
  graph.edges_of = IncidentEdges(as_index(graph.points), graph.edges);
  anchor_components(graph, observations, warnings);
  return graph;
}

}  // namespace vug::survey
