// SPDX-License-Identifier: Apache-2.0
// The costs of directions in the vadose and the phreatic zone.
#include <vug/karst/flow.h>

#include <cmath>

namespace vug::karst {
namespace {

constexpr double kDry = 10;  ///< Factor of the weight for phreatic flow above the water table.

}  // namespace

FlowCost::FlowCost(const SampleGraph& graph, const Rock& rock, const CostOptions& options)
    : graph_(graph), options_(options) {
  for (int tier = 0; tier < rock.tiers(); ++tier) {
    std::vector<double> above;
    above.reserve(graph.points.size());
    for (const Vec3d& point : graph.points)
      above.push_back(point.y - rock.table_height(tier, point));
    above_.push_back(std::move(above));
  }
}

int FlowCost::nearest_tier(int point) const {
  int nearest = 0;
  for (int tier = 1; tier < static_cast<int>(above_.size()); ++tier)
    if (std::abs(above_table(tier, point)) < std::abs(above_table(nearest, point))) nearest = tier;
  return nearest;
}

double FlowCost::vadose(int from, const Arc& arc) const {
  const Vec3d way =
      graph_.points[static_cast<size_t>(arc.to)] - graph_.points[static_cast<size_t>(from)];
  const double length = way.length();
  const double rise = length > 0 ? way.y / length : 0;
  return graph_.cost[static_cast<size_t>(arc.edge)] * (1 + options_.vadose * (1 + rise) / 2);
}

double FlowCost::phreatic(int tier, int from, const Arc& arc) const {
  const double above = (above_table(tier, from) + above_table(tier, arc.to)) / 2;
  double weight = options_.phreatic * (1 - smooth_falloff(above, options_.table_reach));
  if (above > 0) weight *= kDry;
  return graph_.cost[static_cast<size_t>(arc.edge)] * (1 + weight);
}

double FlowCost::anywhere(int from, const Arc& arc) const {
  const int tier = nearest_tier(arc.to);
  const double above = (above_table(tier, from) + above_table(tier, arc.to)) / 2;
  if (above <= 0) return phreatic(tier, from, arc);
  // The direction of the water is unknown, so only steepness matters.
  return std::min(vadose(from, arc), vadose(arc.to, {from, arc.edge}));
}

}  // namespace vug::karst
