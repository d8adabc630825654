// SPDX-License-Identifier: Apache-2.0
#include <vug/network/graph.h>

#include <algorithm>
#include <cmath>

namespace vug::network {
namespace {

std::vector<int> degrees(const Graph& graph) {
  std::vector<int> degree(static_cast<size_t>(graph.nodes), 0);
  for (const auto& [a, b] : graph.edges) {
    ++degree[static_cast<size_t>(a)];
    ++degree[static_cast<size_t>(b)];
  }
  return degree;
}

}  // namespace

std::vector<std::vector<int>> neighbours(const Graph& graph) {
  std::vector<std::vector<int>> of_node(static_cast<size_t>(graph.nodes));
  for (const auto& [a, b] : graph.edges) {
    of_node[static_cast<size_t>(a)].push_back(b);
    of_node[static_cast<size_t>(b)].push_back(a);
  }
  return of_node;
}

std::vector<int> components(const Graph& graph) {
  const auto adjacent = neighbours(graph);
  std::vector<int> component(adjacent.size(), -1);
  int count = 0;
  for (size_t first = 0; first < component.size(); ++first) {
    if (component[first] >= 0) continue;
    std::vector<int> stack{static_cast<int>(first)};
    component[first] = count;
    while (!stack.empty()) {
      const auto node = static_cast<size_t>(stack.back());
      stack.pop_back();
      for (const int next : adjacent[node]) {
        if (component[static_cast<size_t>(next)] >= 0) continue;
        component[static_cast<size_t>(next)] = count;
        stack.push_back(next);
      }
    }
    ++count;
  }
  return component;
}

int component_count(const std::vector<int>& component_of_node) {
  const auto last = std::max_element(component_of_node.begin(), component_of_node.end());
  return last == component_of_node.end() ? 0 : *last + 1;
}

int cycle_count(const Graph& graph) {
  return static_cast<int>(graph.edges.size()) - graph.nodes + component_count(components(graph));
}

double mean_degree(const Graph& graph) {
  if (graph.nodes == 0) return kUndefined;
  return 2 * static_cast<double>(graph.edges.size()) / graph.nodes;
}

double degree_variation(const Graph& graph) {
  if (graph.nodes < 2 || graph.edges.empty()) return kUndefined;
  const double mean = mean_degree(graph);
  double squares = 0;
  for (const int degree : degrees(graph)) squares += (degree - mean) * (degree - mean);
  return std::sqrt(squares / (graph.nodes - 1)) / mean;
}

double degree_correlation(const Graph& graph) {
  if (graph.edges.empty()) return kUndefined;
  const std::vector<int> degree = degrees(graph);
  // Integer sums, so that equal degrees give a variance of exactly 0.
  long long sum = 0;
  long long squares = 0;
  long long products = 0;
  for (const auto& [a, b] : graph.edges) {
    const long long at_a = degree[static_cast<size_t>(a)];
    const long long at_b = degree[static_cast<size_t>(b)];
    sum += at_a + at_b;
    squares += at_a * at_a + at_b * at_b;
    products += 2 * at_a * at_b;
  }
  const auto count = static_cast<long long>(2 * graph.edges.size());
  const long long variance = count * squares - sum * sum;
  if (variance == 0) return 1;
  return static_cast<double>(count * products - sum * sum) / static_cast<double>(variance);
}

}  // namespace vug::network
