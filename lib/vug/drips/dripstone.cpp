// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/chemistry.h>
#include <vug/drips/dripstone.h>
#include <vug/drips/growth.h>
#include <vug/field/boolean.h>

#include <algorithm>

namespace vug::drips {
namespace {

/// Radii of the thickest stalagmites with the scatter of drops, their foot and their coat, in
/// metres.
constexpr double kThickestForm = 0.8;
/// Outlines exceed their radii by girdles, and roots continue by twice the radius and a tip.
constexpr double kWiden = 1.25, kDeepen = 2.1;

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
  const double tallest = std::min(fastest * graph.oldest, graph.to.y - graph.from.y);
  const double radius = std::max({root_radius(common_curve(graph.girth), tallest, forms.tip),
                                  1.2 * forms.tip, kThickestForm}) *
                        kWiden;
  const double lean = 0.09 * tallest;
  return grown(intersection(rock, Box3d(graph.from, graph.to)),
               graph.film.roof_step + radius * (1 + 2 * kDeepen) + forms.tip + lean);
}

}  // namespace vug::drips
