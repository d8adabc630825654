// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/chemistry.h>
#include <vug/drips/dripstone.h>
#include <vug/drips/drop.h>
#include <vug/drips/growth.h>
#include <vug/field/boolean.h>

#include <algorithm>

namespace vug::drips {
namespace {

/// Limits of the constants by which forms grow (forms.cpp, trunk.cpp, outlines.cpp, fallen.cpp), in
/// metres: the trunk with the scatter of its drops, and the coat of a column.
constexpr double kThickestForm = 0.185, kThickestCoat = 0.15;
/// The oldest part of a trunk, a girdle, a plate and a foot, times the radius of the form.
constexpr double kWidestTrunk = 2.1 * 1.7 * 1.14 * 1.9;
/// By these factors waves widen hanging forms and columns, and the end of a coat exceeds its mean.
constexpr double kWidestWave = 1.07, kColumnWave = 1.1, kThickEnd = 1.8;
/// Flutes and lumps stand out by less than this share of the radius.
constexpr double kUneven = 0.6;
/// Roots continue into slopes of up to this tangent, by radii of hanging forms, and by diameters of
/// others. Feet are aside by radii, and hanging forms are in the roof by radii of the tip.
constexpr double kSteepestRoot = 2, kFarthestFoot = 1.6, kSunkTips = 6;
/// The tangent of the lean, and the distance in metres by which the lean moves an axis.
constexpr double kSteepestLean = 0.06, kFarthestLean = 0.03;
/// Pieces roll, and lie on lower floors.
constexpr double kFarthestPiece = 0.8, kLowestPiece = 0.5;

/// By how far solids continue beyond the drips and landings of their forms.
struct SolidReach {
  double aside = 0, up = 0, down = 0;
};

SolidReach reach_of_forms(double tallest, double girth, double finest) {
  const double tip = std::max(finest, 0.5 * straw_diameter(kColdest));
  const field::StalactiteCurve curve = common_curve(girth);
  const double hanging = std::max(
      {root_radius(curve, std::max(tallest, kSunkTips * tip), tip), curve.least_radius(), tip});
  const double trunk = std::max(kThickestForm, 1.2 * finest);
  const double uneven = kUneven * (trunk + kThickestCoat);
  const double widest = kColumnWave * (std::max(kWidestWave * hanging, kWidestTrunk * trunk) +
                                       kThickEnd * kThickestCoat) +
                        uneven;
  // Turned boxes are wider by the lean.
  const double turned = 2 * kSteepestLean * widest;
  const double column = 2 * kSteepestRoot * (trunk + kThickestCoat);
  SolidReach out;
  out.up = std::max(kSteepestRoot * hanging + kSunkTips * tip, column) + tip + uneven + turned;
  out.down =
      std::max({column, (2 + kFarthestFoot) * kSteepestRoot * trunk, kLowestPiece + hanging}) +
      tip + uneven + turned;
  out.aside = std::max(widest + kFarthestFoot * trunk, kFarthestPiece + 2 * hanging) +
              kFarthestLean + kSteepestLean * (out.up + kSunkTips * tip);
  return out;
}

}  // namespace

GrownForms grow_forms(const field::Field& rock, const Graph& graph, const DripstoneOptions& o) {
  GrownForms out;
  out.forms = forms_of(graph, o.forms);
  out.layers = skirts_of(graph, out.forms);
  for (const field::Deposit& layer : flowstone_of(graph, out.forms, o.flowstone))
    out.layers.push_back(layer);
  const std::vector<Form> pieces = fallen_pieces(rock, out.forms, graph, o.forms);
  out.forms.insert(out.forms.end(), pieces.begin(), pieces.end());
  out.draperies = draperies_of(rock, graph, o.draperies);
  return out;
}

Dripstone with_fields(GrownForms grown, const DripstoneOptions& o) {
  // One union: it is restricted once, by the boxes of all its operands.
  std::vector<field::Field> solids = form_fields(grown.forms, o.forms);
  for (const field::Field& sheet : drapery_fields(grown.draperies, o.draperies))
    solids.push_back(sheet);
  field::Field thickness = field::thickness_field(grown.layers);
  return {std::move(grown), field::unite(std::move(solids)), std::move(thickness)};
}

Dripstone grow_dripstone(const field::Field& rock, const Graph& graph, const DripstoneOptions& o) {
  return with_fields(grow_forms(rock, graph, o), o);
}

Box3d dripstone_bounds(const Box3d& rock, const GraphOptions& graph, const FormOptions& forms) {
  const double fastest =
      growth_rate(seep_calcium(graph.temperature, graph.mixing), graph.temperature, 1);
  const double moved = farthest_move(graph);
  const double tallest = std::min(fastest * graph.oldest, graph.to.y - graph.from.y + 2 * moved);
  const SolidReach reach = reach_of_forms(tallest, graph.girth, forms.tip);
  const double step = graph.film.roof_step;
  Box3d out = intersection(rock, Box3d(graph.from, graph.to));
  if (out.isEmpty()) return out;
  out.min -= Vec3d(reach.aside + step, reach.down + moved, reach.aside + step);
  out.max += Vec3d(reach.aside + step, reach.up + step + moved, reach.aside + step);
  return out;
}

}  // namespace vug::drips
