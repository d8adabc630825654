// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/network/metrics.h>
#include <vug/network/reduction.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::network {
namespace {

constexpr size_t kOrientationBins = 18;
constexpr size_t kLengthBins = 10;
/// The bin of a fraction in [0, 1]; 1 is in the last bin.
size_t bin_of(double fraction, size_t bins) {
  return std::min(static_cast<size_t>(fraction * static_cast<double>(bins)), bins - 1);
}

/// -sum(p log p) with the number of bins as the base.
double entropy(const std::vector<double>& weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(total > 0)) return kUndefined;
  double sum = 0;
  for (const double weight : weights)
    if (weight > 0) sum -= weight / total * maths::log(weight / total);
  return sum / maths::log(static_cast<double>(weights.size()));
}

double orientation_entropy(const Network& network, const PlacedGraph& cave) {
  std::vector<double> weights(kOrientationBins, 0.0);
  for (const auto& [a, b] : cave.graph.edges) {
    const Vec3d vector = leg_vector(network, {.from = cave.stations[static_cast<size_t>(a)],
                                              .to = cave.stations[static_cast<size_t>(b)]});
    const double azimuth = folded_azimuth(vector);
    if (std::isnan(azimuth)) continue;
    weights[bin_of(azimuth / kPi, kOrientationBins)] +=
        std::sqrt(vector.x * vector.x + vector.z * vector.z);
  }
  return entropy(weights);
}

void measure_lengths(const std::vector<Branch>& branches, Metrics& metrics) {
  if (branches.empty()) {
    metrics.branch_length = metrics.length_entropy = metrics.length_variation = kUndefined;
    return;
  }
  const auto count = static_cast<double>(branches.size());
  double longest = 0;
  double sum = 0;
  for (const Branch& branch : branches) {
    longest = std::max(longest, branch.length);
    sum += branch.length;
  }
  metrics.branch_length = sum / count;
  double squares = 0;
  std::vector<double> weights(kLengthBins, 0.0);
  for (const Branch& branch : branches) {
    const double difference = branch.length - metrics.branch_length;
    squares += difference * difference;
    if (longest > 0) weights[bin_of(branch.length / longest, kLengthBins)] += 1;
  }
  metrics.length_entropy = entropy(weights);
  metrics.length_variation = branches.size() > 1 && sum > 0
                                 ? std::sqrt(squares / (count - 1)) / metrics.branch_length
                                 : kUndefined;
}

double tortuosity(const Network& network, const std::vector<Branch>& branches) {
  double sum = 0;
  int count = 0;
  for (const Branch& branch : branches) {
    const double distance =
        leg_vector(network, {.from = branch.stations.front(), .to = branch.stations.back()})
            .length();
    if (branch.is_loop() || !(distance > 0)) continue;
    sum += branch.length / distance;
    ++count;
  }
  return count > 0 ? sum / count : kUndefined;
}

}  // namespace

double folded_azimuth(const Vec3d& vector) {
  if (vector.x == 0 && vector.z == 0) return kUndefined;
  double azimuth = maths::atan2(vector.x, -vector.z);
  if (azimuth < 0) azimuth += kPi;
  return azimuth >= kPi ? azimuth - kPi : azimuth;
}

Metrics measure(const Network& network) {
  const PlacedGraph cave = cave_graph(network);
  const Reduction reduction = reduce(network, cave);
  const Graph& graph = reduction.graph;
  Metrics metrics;
  metrics.stations = cave.graph.nodes;
  metrics.legs = static_cast<int>(cave.graph.edges.size());
  metrics.components = component_count(components(cave.graph));
  metrics.cycles = cycle_count(cave.graph);
  metrics.nodes = graph.nodes;
  metrics.edges = static_cast<int>(graph.edges.size());
  for (const Branch& branch : reduction.branches) metrics.length += branch.length;
  metrics.orientation_entropy = orientation_entropy(network, cave);
  measure_lengths(reduction.branches, metrics);
  metrics.tortuosity = tortuosity(network, reduction.branches);
  metrics.degree = mean_degree(graph);
  metrics.degree_variation = degree_variation(graph);
  metrics.degree_correlation = degree_correlation(graph);
  metrics.path_length = mean_path_length(graph);
  metrics.dominance = central_point_dominance(graph);
  return metrics;
}

}  // namespace vug::network
