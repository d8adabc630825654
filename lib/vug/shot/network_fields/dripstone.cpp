// SPDX-License-Identifier: Apache-2.0
// Rock with the speleothems of its drips.
#include <vug/field/boolean.h>
#include <vug/shot/drip_params.h>
#include <vug/shot/networks.h>
#include <vug/shot/speleothem_field.h>

namespace vug::shot {
namespace {

struct Dripstone : DripParams {
  double root = 0.3;

  static void describe(Schema<Dripstone>& s) {
    s.doc(
         "Rock with stalactites and straws at its drips, stalagmites vertically below them, and "
         "columns where they have met.")
        .cite("short2005");
    describe_drips(s);
    describe_forms(s);
    s.param("root", &Dripstone::root,
            positive_length("distance over which roots blend into the rock"));
  }
};

field::Field with_dripstone(const Dripstone& p) {
  drips::GraphOptions graph = p.graph();
  drips::require_valid(graph.edits, graph);
  graph.run_out = false;
  graph.memory = std::numeric_limits<uint64_t>::max();  // Checked before it is computed.
  const auto grow = [rock = p.field, graph, forms = p.forms()] {
    return drips::forms_of(drips::build_graph(rock, graph), forms);
  };
  return field::unite({p.field, speleothem_field(p, grow)}, {field::Profile::smooth, p.root});
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(dripstone) {
  return field::field_kind<Dripstone>("dripstone", "detail", with_dripstone);
}
