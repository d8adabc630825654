// SPDX-License-Identifier: Apache-2.0
#include <vug/base/rng.h>
#include <vug/drips/chemistry.h>
#include <vug/drips/film_network.h>
#include <vug/drips/film_path.h>
#include <vug/drips/layers.h>
#include <vug/field/path.h>
#include <vug/field/speleothems/drapery_sheet.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::drips {
namespace {

/// The share of the excess of calcium that water leaves on the skirt.
constexpr double kSkirtShare = 0.5;
constexpr field::LayerShape kSkirt{
    .slenderness = 0.16, .narrowest = 0.04, .widest = 0.75, .thickest = 0.11};
constexpr field::LayerShape kOnWall{
    .slenderness = 0.2, .narrowest = 0.05, .widest = 0.55, .thickest = 0.14};
constexpr field::LayerShape kOnFloor{
    .slenderness = 0.1, .narrowest = 0.06, .widest = 0.9, .thickest = 0.09};
/// Length of the pieces of a film in metres.
constexpr double kPiece = 0.12;
/// Layers thinner than this in metres are left out: no voxel carries them.
constexpr double kThinnest = 0.001;
/// A skirt is longer downhill by the tangent of the slope, up to this many half-widths.
constexpr double kLongest = 1;

/// The least height of a film's flowstone: the level of the pool into which it runs.
double end_of(const Graph& graph, const Edge& edge) {
  const Node& to = graph.nodes[static_cast<size_t>(edge.to)];
  return to.kind == NodeKind::pool ? to.level : -kInfinity;
}

/// The water that leaves a skirt.
Water after_skirt(Water water) {
  water.calcium -= kSkirtShare * (water.calcium - equilibrium_calcium(water.temperature));
  return water;
}

std::set<int64_t> standing_drips(const std::vector<Form>& forms) {
  std::set<int64_t> drips;
  for (const Form& form : forms)
    if (form.kind == FormKind::stalagmite || form.kind == FormKind::column) drips.insert(form.drip);
  return drips;
}

void add_layers(const Edge& edge, Water water, int64_t drip, double lowest,
                std::vector<field::Deposit>& out) {
  const bool wall = edge.kind == EdgeKind::wall_film;
  const field::LayerShape& shape = wall ? kOnWall : kOnFloor;
  const double width = film_width(edge.kind);
  const double length = field::path_length(edge.path);
  if (!(length > 0)) return;
  const std::vector<Vec3d> path = field::resampled(edge.path, kPiece);
  const double piece = length / static_cast<double>(path.size() - 1);
  // The cross-section at a point is that of the loss per metre there.
  const auto section = [&] {
    const double excess = water.calcium - equilibrium_calcium(water.temperature);
    return deposited_volume(
        water,
        excess * deposition_rate(water.temperature) * width / std::max(water.discharge, 1e-30), 0);
  };
  double before = section();
  for (size_t i = 1; i < path.size() && path[i - 1].y > lowest; ++i) {
    water.calcium = calcium_after(water.calcium, water.temperature, width * piece, water.discharge);
    const double after = section();
    const field::Deposit layer =
        field::Deposit::along(drip, path[i - 1], path[i], before, after, shape);
    if (layer.thickness_from > kThinnest) out.push_back(layer);
    before = after;
  }
}

}  // namespace

double deposited_volume(const Water& water, double from, double to) {
  return kCalciteVolume * (from - to) * water.discharge * water.age * kSecondsPerYear;
}

std::vector<field::Deposit> skirts_of(const Graph& graph, const std::vector<Form>& forms) {
  const std::set<int64_t> drips = standing_drips(forms);
  std::vector<field::Deposit> out;
  for (const Node& node : graph.nodes) {
    if (node.kind != NodeKind::landing || !drips.contains(node.id)) continue;
    const double volume =
        deposited_volume(node.water, node.water.calcium, after_skirt(node.water).calcium);
    if (!(volume > 0)) continue;
    field::Deposit skirt = field::Deposit::around(node.id, node.position, volume, kSkirt);
    const double slope = std::sqrt(std::max(0.0, 1 / (node.normal.y * node.normal.y) - 1));
    skirt.to += film_direction(node.normal) * (skirt.half_width_from * std::min(slope, kLongest));
    out.push_back(skirt);
  }
  return out;
}

std::vector<field::Deposit> flowstone_of(const Graph& graph, const std::vector<Form>& forms,
                                         const FlowstoneOptions& o) {
  const std::set<int64_t> drips = standing_drips(forms);
  std::vector<field::Deposit> out;
  // Once water leaves flowstone, it does so all the way. Edges are in the order of the flow.
  std::set<int> depositing;
  for (const Edge& edge : graph.edges) {
    if (edge.kind != EdgeKind::wall_film && edge.kind != EdgeKind::floor_film) continue;
    const Node& from = graph.nodes[static_cast<size_t>(edge.from)];
    RandomStream random(RandomKey(o.seed).at("flowstone").at(static_cast<uint64_t>(from.id)));
    const bool source = from.kind == NodeKind::landing ||
                        (from.kind == NodeKind::bend && edge.kind == EdgeKind::wall_film);
    if (!(depositing.contains(edge.from) || (source && random.uniform() < o.share))) continue;
    depositing.insert(edge.to);
    const bool skirted = from.kind == NodeKind::landing && drips.contains(from.id);
    add_layers(edge, skirted ? after_skirt(edge.water) : edge.water, from.id, end_of(graph, edge),
               out);
  }
  return out;
}

}  // namespace vug::drips
