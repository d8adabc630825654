// SPDX-License-Identifier: Apache-2.0
#include <vug/network/elements.h>
#include <vug/network/reduction.h>

#include <boost/algorithm/string/predicate.hpp>

#include <cmath>
#include <map>

namespace vug::network {
namespace {

/// x along `direction`, z horizontal, y as far up as possible.
Transform frame_at(const Vec3d& origin, const Vec3d& direction) {
  const Vec3d x = direction.normalized();
  const Vec3d side = x.cross({0, 1, 0});
  const Vec3d z = side.length() > 1e-9 ? side.normalized() : Vec3d(0, 0, 1);
  return {x, z.cross(x), z, origin};
}

/// The legs of the cave's graph: the first one of those between the same two stations.
class Graphed {
 public:
  explicit Graphed(const Network& network) : network_(network), cave_(cave_graph(network)) {
    for (size_t i = 0; i < network.legs.size(); ++i) {
      const Leg& leg = network.legs[i];
      if (!leg.surface && !leg.duplicate)
        legs_.try_emplace(std::minmax(leg.from, leg.to), static_cast<int>(i));
    }
    for (const auto& [a, b] : cave_.graph.edges) {
      edge_legs_.push_back(legs_.at(std::minmax(station(a), station(b))));
      at_node_[a].push_back(edge_legs_.back());
      at_node_[b].push_back(edge_legs_.back());
    }
  }

  std::vector<Element> legs() const {
    std::vector<Element> out;
    for (const int index : edge_legs_) {
      const Leg& leg = network_.legs[static_cast<size_t>(index)];
      const Vec3d vector = leg_vector(network_, leg);
      if (!(vector.length() > 0)) continue;
      out.push_back(
          {ElementKind::leg, index, 1, frame_at(position(leg.from) + 0.5 * vector, vector)});
    }
    return out;
  }

  std::vector<Element> stations(ElementKind kind) const {
    std::vector<Element> out;
    for (const auto& [node, legs] : at_node_) {
      if (kind_of(node, legs) != kind) continue;
      const int at = station(node);
      const Leg& first = network_.legs[static_cast<size_t>(legs.front())];
      const Vec3d away = leg_vector(network_, first) * (first.from == at ? 1 : -1);
      const Vec3d x = legs.size() == 1 ? -away : away;
      out.push_back(
          {kind, at, static_cast<int>(legs.size()),
           x.length() > 0 ? frame_at(position(at), x) : Transform::translation(position(at))});
    }
    return out;
  }

 private:
  int station(int node) const { return cave_.stations[static_cast<size_t>(node)]; }
  const Vec3d& position(int station) const {
    return network_.stations[static_cast<size_t>(station)].position;
  }

  /// `leg` for stations between two legs.
  ElementKind kind_of(int node, const std::vector<int>& legs) const {
    if (legs.size() > 2) return ElementKind::junction;
    if (legs.size() == 2) return ElementKind::leg;
    const Station& at = network_.stations[static_cast<size_t>(station(node))];
    if (at.flags.entrance || at.flags.sink || at.flags.spring) return ElementKind::end;
    const std::string level = at.name.substr(at.name.rfind('.') + 1);
    const Leg& leg = network_.legs[static_cast<size_t>(legs.front())];
    const bool flooded = leg.stage == Stage::phreatic && leg.tier == 0;
    return flooded || boost::algorithm::istarts_with(level, "sump") ? ElementKind::sump
                                                                    : ElementKind::end;
  }

  const Network& network_;
  PlacedGraph cave_;
  std::map<std::pair<int, int>, int> legs_;
  std::vector<int> edge_legs_;               ///< The leg of each edge of the graph.
  std::map<int, std::vector<int>> at_node_;  ///< The legs of each node.
};

std::optional<double> sum(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::optional(*a + *b) : std::nullopt;
}

ElementSize size_at(const Network& network, int station) {
  const auto& section = network.stations[static_cast<size_t>(station)].section;
  if (!section) return {};
  return {sum(section->left, section->right), sum(section->up, section->down)};
}

std::optional<double> mean(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::optional((*a + *b) / 2) : a ? a : b;
}

}  // namespace

std::vector<Element> elements(const Network& network, ElementKind kind) {
  require_valid(network);
  const Graphed graphed(network);
  return kind == ElementKind::leg ? graphed.legs() : graphed.stations(kind);
}

ElementSize size_of(const Network& network, const Element& element) {
  if (element.kind != ElementKind::leg) return size_at(network, element.index);
  const Leg& leg = network.legs[static_cast<size_t>(element.index)];
  const ElementSize from = size_at(network, leg.from), to = size_at(network, leg.to);
  return {mean(from.width, to.width), mean(from.height, to.height)};
}

}  // namespace vug::network
