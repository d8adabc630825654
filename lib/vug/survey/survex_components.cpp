// SPDX-License-Identifier: Apache-2.0
// The rules follow from the output of cavern 1.4.4 for small random surveys.
#include <vug/survey/survex_components.h>

#include <vug/base/disjoint_sets.h>

#include <algorithm>
#include <array>

namespace vug::survey {
namespace {

size_t as_size(int i) { return static_cast<size_t>(i); }

/// A place where a leg meets a node: its number and one of its three legs.
struct Slot {
  int node = -1;
  size_t leg = 0;
};

struct Node {
  int station = -1;  ///< -1 for the place of a fix with deviations.
  std::array<Slot, 3> legs;
};

/// The nodes of a survey in the order in which cavern creates them.
class Nodes {
 public:
  explicit Nodes(size_t stations) : node_of_(stations, -1), equal_(stations) {
    nodes_.reserve(stations + stations / 8);
  }

  int node_of(int station) {
    int& node = node_of_[as_size(station)];
    if (node < 0) node = add(station);
    return node;
  }
  void join(int a, int b) {
    const Slot one = free_slot(a), other = free_slot(b);
    at(one) = other;
    at(other) = one;
  }
  void add_leg(int from, int to) {
    const int a = node_of(from), b = node_of(to);
    join(a, b);
  }
  /// Equates of stations that are already equal do not add a leg.
  void add_equate(int a, int b) {
    const int second = node_of(b), first = node_of(a);  // The second name is new first.
    if (equal_.join(a, b)) join(first, second);
  }
  void add_fix(const Fix& fix) {
    const int node = node_of(fix.station);
    if (!fix.covariance)
      fixed_stations_.push_back(fix.station);
    else
      join(add(-1), node);
  }
  /// Marks which nodes are fixed; without fixes, the first one.
  std::vector<bool> fixed() {
    if (fixed_stations_.empty() && !has_places_ && !nodes_.empty())
      fixed_stations_.push_back(nodes_[0].station);
    std::vector<bool> set(equal_.size(), false), out;
    for (const int station : fixed_stations_) set[as_size(equal_.root(station))] = true;
    for (const Node& node : nodes_)
      out.push_back(node.station < 0 || set[as_size(equal_.root(node.station))]);
    return out;
  }
  const std::vector<Node>& all() const { return nodes_; }

 private:
  Slot& at(const Slot& slot) { return nodes_[as_size(slot.node)].legs[slot.leg]; }
  int add(int station) {
    has_places_ = has_places_ || station < 0;
    nodes_.push_back({station, {}});
    return static_cast<int>(nodes_.size()) - 1;
  }
  /// A new node takes over the first leg of a full one, and has room for one more leg.
  Slot free_slot(int node) {
    for (size_t leg = 0; leg < 3; ++leg)
      if (nodes_[as_size(node)].legs[leg].node < 0) return {node, leg};
    const int more = add(nodes_[as_size(node)].station);
    const Slot old{node, 0}, moved = at(old);
    at({more, 0}) = moved;
    at(moved) = {more, 0};
    at({more, 1}) = old;
    at(old) = {more, 1};
    return {more, 2};
  }

  std::vector<Node> nodes_;
  std::vector<int> node_of_;
  DisjointSets<int> equal_;
  std::vector<int> fixed_stations_;
  bool has_places_ = false;
};

/// Adds fixes, equates and legs in the order of the text.
void add_in_order(const Observations& observations, Nodes& nodes) {
  const std::vector<Fix>& fixes = observations.fixes;
  const std::vector<Equate>& equates = observations.equates;
  size_t fix = 0, equate = 0;
  const auto add_before = [&](size_t leg) {
    for (;;) {
      if (fix < fixes.size() && fixes[fix].legs_before <= leg &&
          fixes[fix].equates_before <= equate)
        nodes.add_fix(fixes[fix++]);
      else if (equate < equates.size() && equates[equate].legs_before <= leg)
        nodes.add_equate(equates[equate].a, equates[equate].b), ++equate;
      else
        return;
    }
  };
  for (size_t i = 0; i < observations.legs.size(); ++i) {
    add_before(i);
    const Leg& leg = observations.legs[i].leg;
    if (leg.style != Style::nosurvey && leg.from != leg.to) nodes.add_leg(leg.from, leg.to);
  }
  add_before(observations.legs.size());
}

}  // namespace

std::optional<int> survex_components(const Observations& observations) {
  Nodes nodes(observations.stations.size());
  add_in_order(observations, nodes);
  const std::vector<bool> fixed = nodes.fixed();
  std::vector<bool> reached(fixed.size(), false);
  int components = 0;
  std::vector<int> open;
  for (size_t i = 0; i < fixed.size(); ++i) {
    if (!fixed[i]) continue;
    if (!reached[i]) ++components;
    reached[i] = true;
    open.push_back(static_cast<int>(i));
    while (!open.empty()) {
      const Node& node = nodes.all()[as_size(open.back())];
      open.pop_back();
      for (const Slot& slot : node.legs) {
        if (slot.node < 0 || reached[as_size(slot.node)]) continue;
        reached[as_size(slot.node)] = true;
        if (!fixed[as_size(slot.node)]) open.push_back(slot.node);
      }
    }
  }
  if (std::find(reached.begin(), reached.end(), false) != reached.end()) return std::nullopt;
  return components;
}

}  // namespace vug::survey
