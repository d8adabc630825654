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

Dripstone grow_dripstone(const field::Field& rock, const Graph& graph, const DripstoneOptions& o) {
  std::vector<Form> forms = forms_of(graph, o.forms);
  std::vector<field::Deposit> layers = skirts_of(graph, forms);
  for (const field::Deposit& layer : flowstone_of(graph, forms, o.flowstone))
    layers.push_back(layer);
  const std::vector<Form> pieces = fallen_pieces(rock, forms, graph, o.forms);
  forms.insert(forms.end(), pieces.begin(), pieces.end());
  // One union: it is restricted once, by the boxes of all its operands.
  std::vector<field::Field> solids = form_fields(forms, o.forms);
  std::vector<HungDrapery> draperies = draperies_of(rock, graph, o.draperies);
  for (const field::Field& sheet : drapery_fields(draperies, o.draperies)) solids.push_back(sheet);
  field::Field thickness = field::thickness_field(layers);
  return {std::move(forms), std::move(draperies), std::move(layers),
          field::unite(std::move(solids)), std::move(thickness)};
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
