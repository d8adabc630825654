// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/chemistry.h>
#include <vug/drips/film_path.h>
#include <vug/drips/layers.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::drips {
namespace {

/// The share of the excess of calcium that water leaves on the skirt.
constexpr double kSkirtShare = 0.5;
constexpr field::LayerShape kSkirt{
    .slenderness = 0.16, .narrowest = 0.04, .widest = 0.75, .thickest = 0.11};
/// A skirt is longer downhill by the tangent of the slope, up to this many half-widths.
constexpr double kLongest = 1;

}  // namespace

double deposited_volume(const Water& water, double from, double to) {
  return kCalciteVolume * (from - to) * water.discharge * water.age * kSecondsPerYear;
}

std::vector<field::Deposit> skirts_of(const Graph& graph, const std::vector<Form>& forms) {
  std::set<int64_t> standing;
  for (const Form& form : forms)
    if (form.kind == FormKind::stalagmite || form.kind == FormKind::column)
      standing.insert(form.drip);
  std::vector<field::Deposit> out;
  for (const Node& node : graph.nodes) {
    if (node.kind != NodeKind::landing || !standing.contains(node.id)) continue;
    const double least = equilibrium_calcium(node.water.temperature);
    const double left = node.water.calcium - kSkirtShare * (node.water.calcium - least);
    const double volume = deposited_volume(node.water, node.water.calcium, left);
    if (!(volume > 0)) continue;
    field::Deposit skirt = field::Deposit::around(node.id, node.position, volume, kSkirt);
    const double slope = std::sqrt(std::max(0.0, 1 / (node.normal.y * node.normal.y) - 1));
    skirt.to += film_direction(node.normal) * (skirt.half_width_from * std::min(slope, kLongest));
    out.push_back(skirt);
  }
  return out;
}

}  // namespace vug::drips
