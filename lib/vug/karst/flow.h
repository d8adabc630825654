// SPDX-License-Identifier: Apache-2.0
// The ways of water from sinks to springs, and the costs of directions.
#pragma once

#include <vug/karst/plan.h>
#include <vug/karst/samples.h>

namespace vug::karst {

/// The direction-dependent costs of arcs.
class FlowCost {
 public:
  FlowCost(const SampleGraph& graph, const Rock& rock, const CostOptions& options);

  /// The height of a point above the water table of a tier, in metres.
  double above_table(int tier, int point) const {
    return above_[static_cast<size_t>(tier)][static_cast<size_t>(point)];
  }
  /// The zone of a point at the time of a tier.
  network::Stage stage(int tier, int point) const { return stage_at(above_table(tier, point)); }
  /// The zone of the middle between two points at the time of a tier.
  network::Stage stage(int tier, int a, int b) const {
    return stage_at(above_table(tier, a) + above_table(tier, b));
  }
  /// The tier whose water table is nearest to a point.
  int nearest_tier(int point) const;

  /// Falling is free of the weight, horizontal flow has half of it, and rising has all of it.
  double vadose(int from, const Arc& arc) const;
  /// Legs at the water table are free of the weight, deep ones and dry ones have it.
  double phreatic(int tier, int from, const Arc& arc) const;
  /// The cost by the zone of the arc's middle at the time of the tier that is nearest to its end,
  /// for passages without known flow.
  double anywhere(int from, const Arc& arc) const;

 private:
  static network::Stage stage_at(double above) {
    return above > 0 ? network::Stage::vadose : network::Stage::phreatic;
  }

  const SampleGraph& graph_;
  const CostOptions& options_;
  std::vector<std::vector<double>> above_;  ///< For each tier and point.
};

/// Adds the ways from each sink to the springs, from the oldest tier to the present one: from the
/// sink to the water table through the vadose zone, then to the cheapest spring of the tier through
/// the phreatic zone. Ways that exist are cheaper, so later ones join them.
void add_flow(const FlowCost& cost, const KeyPoints& keys, const Samples& samples,
              const KarstOptions& options, Plan& plan);

}  // namespace vug::karst
