// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/tree.h>

#include <fmt/format.h>

namespace vug::facade {

namespace {

constexpr double kMostElements = 1e6;

size_t index(int node) { return static_cast<size_t>(node); }

}  // namespace

std::vector<double> occurrences(const Tree& tree) {
  std::vector<double> out(tree.nodes.size(), 1.0);
  for (size_t i = 0; i < out.size(); ++i) {
    const Node& node = tree.nodes[i];
    out[i] = (node.parent < 0 ? 1.0 : out[index(node.parent)]) *
             static_cast<double>(1 + node.copies.size());
  }
  return out;
}

std::vector<Placement> placements(const Tree& tree, int node) {
  std::vector<int> way;  // from the node up
  for (int at = node; at >= 0; at = tree.nodes[index(at)].parent) way.push_back(at);
  std::vector<Placement> out{{}};
  for (size_t i = way.size(); i-- > 0;) {
    const std::vector<Placement>& copies = tree.nodes[index(way[i])].copies;
    std::vector<Placement> next;
    next.reserve(out.size() * (1 + copies.size()));
    for (const Placement& outer : out) {
      next.push_back(outer);
      for (const Placement& inner : copies) next.push_back(outer.after(inner));
    }
    out = std::move(next);
  }
  return out;
}

std::vector<ElementInstance> element_instances(const Tree& tree) {
  const std::vector<double> counts = occurrences(tree);
  double total = 0;
  for (size_t i = 0; i < counts.size(); ++i)
    if (tree.nodes[i].element) total += counts[i];
  if (total > kMostElements)
    throw Error(ErrorCode::too_large,
                fmt::format("the facade '{}' has {:.3g} elements, more than {:.0f}", tree.name,
                            total, kMostElements));
  std::vector<ElementInstance> out;
  out.reserve(static_cast<size_t>(total));
  for (size_t i = 0; i < counts.size(); ++i) {
    if (!tree.nodes[i].element) continue;
    for (const Placement& place : placements(tree, static_cast<int>(i)))
      out.push_back({static_cast<int>(i), place(tree.nodes[i].rect),
                     place.mirrored != tree.nodes[i].mirrored});
  }
  return out;
}

}  // namespace vug::facade
