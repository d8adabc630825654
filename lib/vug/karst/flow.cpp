// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/karst/flow.h>
#include <vug/karst/search.h>

namespace vug::karst {
namespace {

class Flow {
 public:
  Flow(const FlowCost& cost, const KarstOptions& options, Plan& plan)
      : cost_(cost), options_(options), plan_(plan) {}

  void add(const Sink& sink, int source, int tier, const std::vector<int>& springs) {
    std::vector<bool> is_spring(plan_.graph().points.size(), false);
    for (const int spring : springs) is_spring[static_cast<size_t>(spring)] = true;
    const auto is_end = [&](int point) { return is_spring[static_cast<size_t>(point)]; };
    int at = source;
    if (cost_.stage(tier, source) == network::Stage::vadose)
      at = run(
          sink, source, tier,
          [&](int point) {
            return is_end(point) || cost_.stage(tier, point) == network::Stage::phreatic;
          },
          [&](int from, const Arc& arc) { return cost_.vadose(from, arc); });
    if (!is_end(at))
      run(sink, at, tier, is_end,
          [&](int from, const Arc& arc) { return cost_.phreatic(tier, from, arc); });
  }

 private:
  /// Adds the cheapest way from a point to one that ends it, and returns that one.
  template <class IsEnd, class Cost>
  int run(const Sink& sink, int source, int tier, const IsEnd& is_end, const Cost& cost) {
    const auto with_reuse = [&](int from, const Arc& arc) {
      const Passage& passage = plan_.passage(arc.edge);
      if (passage.from < 0) return cost(from, arc);
      const bool upstream = passage.water && passage.water_tier == tier && passage.from != from;
      return cost(from, arc) * (upstream ? kUpstream : options_.cost.reuse + kLeast);
    };
    const SearchTree tree = search(plan_.graph(), source, with_reuse, [&](int point) {
      return is_end(point) ? Visit::stop : Visit::expand;
    });
    if (tree.reached < 0)
      throw Error(ErrorCode::bad_input, fmt::format("no way leads from {} to the water", sink.name),
                  {}, "place springs in the rock, at or below the water table of their tier");
    const std::vector<int> path = tree.path_to(tree.reached);
    for (size_t i = 1; i < path.size(); ++i)
      flow_through(tree.parent_edge[static_cast<size_t>(path[i])], path[i - 1], path[i], tier,
                   sink.discharge);
    return tree.reached;
  }

  void flow_through(int edge, int from, int to, int tier, double discharge) {
    Passage passage = plan_.passage(edge);
    if (passage.from < 0) {
      passage.tier = tier;
      passage.stage = cost_.stage(tier, from, to);
    }
    // Former water does not add to younger water, which may also run the other way.
    if (!passage.water || passage.water_tier != tier) {
      passage.discharge = 0;
      passage.from = from;
    }
    // Where no other way exists, water may run against other water; the difference remains.
    passage.discharge += passage.from == from ? discharge : -discharge;
    if (passage.discharge < 0) {
      passage.discharge = -passage.discharge;
      passage.from = from;
    }
    passage.water_tier = tier;
    passage.water = true;
    plan_.set(edge, passage);
  }

  static constexpr double kLeast = 1e-6;     ///< So that no way is free.
  static constexpr double kUpstream = 1000;  ///< Factor of the cost against the water of a tier.

  const FlowCost& cost_;
  const KarstOptions& options_;
  Plan& plan_;
};

}  // namespace

void add_flow(const FlowCost& cost, const KeyPoints& keys, const Samples& samples,
              const KarstOptions& options, Plan& plan) {
  int tiers = 1;
  for (const Spring& spring : keys.springs) tiers = std::max(tiers, spring.tier + 1);
  Flow flow(cost, options, plan);
  for (int tier = tiers - 1; tier >= 0; --tier) {
    std::vector<int> springs;
    for (size_t i = 0; i < keys.springs.size(); ++i)
      if (keys.springs[i].tier == tier) springs.push_back(samples.springs + static_cast<int>(i));
    if (springs.empty()) continue;  // A water table without springs leaves no conduits.
    for (size_t i = 0; i < keys.sinks.size(); ++i)
      flow.add(keys.sinks[i], samples.sinks + static_cast<int>(i), tier, springs);
  }
}

}  // namespace vug::karst
