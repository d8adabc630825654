// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/karst/growth.h>
#include <vug/karst/search.h>

#include <cmath>

namespace vug::karst {
namespace {

constexpr int kMostFailures = 40;  ///< Consecutive attempts without room for a passage.
constexpr double kDetour = 1.5;    ///< A loop must be this much shorter than the existing way.

class Growth {
 public:
  Growth(const FlowCost& cost, const KarstOptions& options, Plan& plan)
      : cost_(cost),
        options_(options.growth),
        plan_(plan),
        random_(RandomKey(options.seed).at("growth")) {}

  void run() {
    int dead_ends = options_.dead_ends;
    for (int failures = 0; failures < kMostFailures;) {
      const Size size = measure();
      const double wanted = options_.loops * (size.nodes + 2 * dead_ends);
      bool done = false;
      if (size.cycles > wanted + 0.5 && cut_possible_) {
        done = cut_possible_ = cut_loop(random_, plan_);
      } else {
        const double missing = std::max(0.0, std::round(wanted) - size.cycles);
        if (missing + dead_ends <= 0) break;
        const bool loop = random_.uniform() * (missing + dead_ends) < missing;
        done = loop ? add_loop() : add_dead_end();
        if (done && !loop) --dead_ends;
      }
      failures = done ? 0 : failures + 1;
    }
  }

 private:
  struct Size {
    int nodes = 0;   ///< Junctions and ends.
    int cycles = 0;  ///< The plan is connected.
  };

  Size measure() {
    points_ = plan_.points();
    junctions_.clear();
    sides_.clear();
    Size size;
    int ends_of_edges = 0;
    for (const int point : points_) {
      ends_of_edges += plan_.degree(point);
      if (plan_.degree(point) == 2) sides_.push_back(point);
      if (plan_.degree(point) == 3) junctions_.push_back(point);
      if (plan_.degree(point) != 2) ++size.nodes;
    }
    size.cycles = ends_of_edges / 2 - static_cast<int>(points_.size()) + 1;
    return size;
  }

  const Vec3d& position(int point) const {
    return plan_.graph().points[static_cast<size_t>(point)];
  }

  int any_of(const std::vector<int>& points) {
    return points[random_.below(static_cast<uint32_t>(points.size()))];
  }

  /// A point of the network at which a passage starts.
  int start() {
    const double choice = random_.uniform();
    if (choice < options_.at_junctions && !junctions_.empty()) return any_of(junctions_);
    const std::vector<int>& points = sides_.empty() ? points_ : sides_;
    if (choice < options_.at_junctions + options_.clustering && !starts_.empty()) {
      const Vec3d& middle = position(any_of(starts_));
      std::vector<int> near;
      for (const int point : points)
        if ((position(point) - middle).length() < options_.cluster_radius) near.push_back(point);
      if (!near.empty()) return any_of(near);
    }
    return any_of(points);
  }

  bool add_dead_end() {
    const int from = start();
    const double length =
        options_.dead_end_length * maths::exp(options_.dead_end_spread * random_.normal());
    const SearchTree tree = search(
        plan_.graph(), from, [&](int at, const Arc& arc) { return cost_.anywhere(at, arc); },
        [&](int point) {
          if (point == from) return Visit::expand;
          if (plan_.contains(point)) return Visit::block;
          return (position(point) - position(from)).length() >= length ? Visit::stop
                                                                       : Visit::expand;
        });
    if (tree.reached < 0) return false;
    add(tree, from);
    return true;
  }

  bool add_loop() {
    const int from = start();
    const SearchTree existing = search(
        plan_.graph(), from,
        [&](int, const Arc& arc) {
          return plan_.has(arc.edge) ? plan_.graph().length(arc.edge) : kInfinity;
        },
        [](int) { return Visit::expand; });
    const SearchTree tree = search(
        plan_.graph(), from, [&](int at, const Arc& arc) { return cost_.anywhere(at, arc); },
        [&](int point) {
          if (point == from || !plan_.contains(point)) return Visit::expand;
          const double distance = (position(point) - position(from)).length();
          const bool far = distance >= options_.loop_least && distance <= options_.loop_most;
          const bool short_cut = existing.cost[static_cast<size_t>(point)] > kDetour * distance;
          const bool neighbour = plan_.edge_between(from, point) >= 0;
          return far && short_cut && !neighbour ? Visit::stop : Visit::block;
        });
    if (tree.reached < 0) return false;
    add(tree, from);
    return true;
  }

  /// Adds the passage from `from` to the point that the search reached. The water of a dead end
  /// runs towards the network.
  void add(const SearchTree& tree, int from) {
    starts_.push_back(from);
    for (int point = tree.reached; point != from; point = tree.parent[static_cast<size_t>(point)]) {
      const int before = tree.parent[static_cast<size_t>(point)];
      const int tier = cost_.nearest_tier(point);
      plan_.set(tree.parent_edge[static_cast<size_t>(point)],
                {.from = point, .stage = cost_.stage(tier, point, before), .tier = tier});
    }
  }

  const FlowCost& cost_;
  const GrowthOptions& options_;
  Plan& plan_;
  RandomStream random_;
  std::vector<int> points_;
  std::vector<int>
      junctions_;           ///< Junctions of three passages; larger ones are rare in real caves.
  std::vector<int> sides_;  ///< Points between junctions.
  std::vector<int> starts_;
  bool cut_possible_ = true;
};

}  // namespace

void grow(const FlowCost& cost, const KarstOptions& options, Plan& plan) {
  if (!plan.points().empty()) Growth(cost, options, plan).run();
}

}  // namespace vug::karst
