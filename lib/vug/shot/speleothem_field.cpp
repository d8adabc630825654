// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/dripstone.h>
#include <vug/drips/form_fields.h>
#include <vug/field/deferred.h>
#include <vug/shot/speleothem_field.h>

namespace vug::shot {

field::Field speleothem_field(const DripParams& params,
                              std::function<std::vector<drips::Form>()> grow) {
  const drips::GraphOptions graph = params.graph();
  const drips::FormOptions forms = params.forms();
  const field::Traits traits{1, field::Exactness::eikonal,
                             drips::dripstone_bounds(params.field.bounds(), graph, forms), 1};
  return field::deferred(
      traits, "finding drips",
      [grow = std::move(grow), forms] { return drips::forms_field(grow(), forms); },
      drips::graph_memory(graph));
}

}  // namespace vug::shot
