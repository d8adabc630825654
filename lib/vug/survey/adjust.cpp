// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/adjust.h>

#include <vug/survey/blunders.h>
#include <vug/survey/junctions.h>
#include <vug/survey/survex_components.h>

#include <algorithm>
#include <cmath>

namespace vug::survey {
namespace {

/// The number of traverses that are searched for blunders, those with the largest misclosures.
constexpr size_t kMostSearched = 500;

/// A chain in a loop with its misclosure.
struct OpenChain {
  size_t chain;
  Misclosure misclosure;
};

/// The root of the sum of squares over the variance; 0 for a misclosure of 0.
double ratio(double squared, double variance) {
  return variance > 0 ? std::sqrt(squared / variance) : 0;
}

Misclosure measure_misclosure(const LegGraph& graph, const Observations& observations,
                              const TraverseChain& chain, const ChainSum& sum) {
  const auto& positions = graph.positions;
  const Vec3d error = from_eigen(sum.vector) - (*positions[static_cast<size_t>(chain.to)] -
                                                *positions[static_cast<size_t>(chain.from)]);
  Misclosure out;
  out.error = error;
  const Eigen::Matrix3d& v = sum.covariance;
  const double flat = error.x * error.x + error.y * error.y, high = error.z * error.z;
  out.e = ratio(flat + high, v.trace());
  out.h = ratio(flat, v(0, 0) + v(1, 1));
  out.v = ratio(high, v(2, 2));
  int point = chain.from;
  const auto add_station = [&] {
    const int station = graph.station_of[static_cast<size_t>(point)];
    if (station >= 0) out.stations.push_back(station);
  };
  add_station();
  for (const int edge : chain.edges) {
    point = graph.across(edge, point);
    add_station();
    const int leg = graph.edges[static_cast<size_t>(edge)].leg;
    if (leg < 0) continue;
    ++out.legs;
    out.length += std::fabs(observations.legs[static_cast<size_t>(leg)].leg.length);
  }
  return out;
}

/// Sets the positions along a chain: each leg takes the part of the misclosure that corresponds to
/// its covariance.
void place_chain(LegGraph& graph, const TraverseChain& chain, const ChainSum& sum) {
  Vec3d position = *graph.positions[static_cast<size_t>(chain.from)];
  const Vec3d end = *graph.positions[static_cast<size_t>(chain.to)];
  const Eigen::Vector3d weighted =
      sum.covariance.inverse() * (sum.vector - as_eigen(end - position));
  int point = chain.from;
  for (size_t i = 0; i + 1 < chain.edges.size(); ++i) {
    const Edge& edge = graph.edges[static_cast<size_t>(chain.edges[i])];
    position += from_eigen((chain.forwards[i] ? 1 : -1) * as_eigen(edge.vector) -
                           as_eigen(edge.covariance) * weighted);
    point = graph.across(chain.edges[i], point);
    graph.positions[static_cast<size_t>(point)] = position;
  }
}

void place_dead_ends(LegGraph& graph, const std::vector<DeadEnd>& dead_ends) {
  for (auto each = dead_ends.rbegin(); each != dead_ends.rend(); ++each) {
    const Edge& edge = graph.edges[static_cast<size_t>(each->edge)];
    const Vec3d& from =
        *graph.positions[static_cast<size_t>(graph.across(each->edge, each->point))];
    graph.positions[static_cast<size_t>(each->point)] =
        edge.b == each->point ? from + edge.vector : from - edge.vector;
  }
}

/// A station of legs on the surface and below it has both flags.
void flag_stations(Survey& survey) {
  for (const Leg& leg : survey.legs)
    for (const int end : {leg.from, leg.to}) {
      Station& station = survey.stations[static_cast<size_t>(end)];
      (leg.surface ? station.surface : station.underground) = true;
    }
}

Survey survey_of(Observations&& observations, const LegGraph& graph) {
  Survey survey;
  survey.title = std::move(observations.title);
  survey.coordinate_system = std::move(observations.coordinate_system);
  survey.stations = std::move(observations.stations);
  for (size_t i = 0; i < survey.stations.size(); ++i)
    survey.stations[i].position = *graph.positions[static_cast<size_t>(graph.point_of[i])];
  for (const Fix& fix : observations.fixes)
    survey.stations[static_cast<size_t>(fix.station)].fixed = true;
  survey.legs.reserve(observations.legs.size());
  for (ObservedLeg& each : observations.legs) {
    each.leg.plan_length = std::hypot(each.vector.x, each.vector.y);
    each.leg.vertical_length = std::fabs(each.vector.z);
    survey.legs.push_back(std::move(each.leg));
  }
  survey.equates = std::move(observations.equates);
  survey.tubes = std::move(observations.tubes);
  survey.files = std::move(observations.files);
  flag_stations(survey);
  return survey;
}

}  // namespace

Survey adjust(Observations observations, Diagnostics& warnings) {
  LegGraph graph = make_leg_graph(observations, warnings);
  const Traverses traverses = find_traverses(graph);
  std::vector<ChainSum> sums;
  sums.reserve(traverses.chains.size());
  for (const TraverseChain& chain : traverses.chains) sums.emplace_back(graph, chain);
  const JunctionSolver solver(graph, traverses.chains, sums);

  std::vector<OpenChain> open;
  for (size_t i = 0; i < sums.size(); ++i)
    if (!traverses.chains[i].bridge)
      open.push_back({i, measure_misclosure(graph, observations, traverses.chains[i], sums[i])});
  std::stable_sort(open.begin(), open.end(), [](const OpenChain& a, const OpenChain& b) {
    return a.misclosure.e > b.misclosure.e;
  });
  std::vector<Blunder> blunders;
  for (size_t i = 0; i < std::min(open.size(), kMostSearched); ++i) {
    const size_t chain = open[i].chain;
    const Eigen::Matrix3d residual =
        sums[chain].covariance - solver.covariance_between(traverses.chains[chain]);
    const auto found =
        find_blunders(graph, observations, traverses.chains[chain],
                      {as_eigen(open[i].misclosure.error), sums[chain].covariance, residual});
    blunders.insert(blunders.end(), found.begin(), found.end());
  }
  for (size_t i = 0; i < sums.size(); ++i) place_chain(graph, traverses.chains[i], sums[i]);
  place_dead_ends(graph, traverses.dead_ends);
  separate_components(graph);

  const std::optional<int> survex = survex_components(observations);
  Survey survey = survey_of(std::move(observations), graph);
  survey.survex_components = survex;
  for (OpenChain& each : open) survey.misclosures.push_back(std::move(each.misclosure));
  survey.blunders = std::move(blunders);
  return survey;
}

}  // namespace vug::survey
