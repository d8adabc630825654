// SPDX-License-Identifier: Apache-2.0
// Rock with the speleothems of its drips.
#include <vug/drips/dripstone.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/shot/drip_params.h>
#include <vug/shot/networks.h>

#include <limits>

namespace vug::shot {
namespace {

struct Dripstone : DripParams {
  double tip = 0.01;
  double stalagmites = 0.6;
  double broken = 0.07;
  double root = 0.3;

  static void describe(Schema<Dripstone>& s) {
    const auto share = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::ratio, .min = 0, .max = 1};
    };
    s.doc(
         "Rock with stalactites and straws at its drips, stalagmites vertically below them, and "
         "columns where they have met.")
        .cite("short2005");
    describe_drips(s);
    s.param("tip", &Dripstone::tip,
            positive_length("least radius of every form: 2.55 mm in nature, but at least 0.75 "
                            "voxels. Stalactites of less than six radii are left out"))
        .param("stalagmites", &Dripstone::stalagmites,
               share("share of the drips with a stalagmite below"))
        .param("broken", &Dripstone::broken, share("share of the stalactites that broke"))
        .param("root", &Dripstone::root,
               positive_length("distance over which roots blend into the rock"));
  }

  drips::FormOptions forms() const {
    return {.girth = girth,
            .tip = tip,
            .stalagmites = stalagmites,
            .broken = broken,
            .seed = static_cast<uint64_t>(seed)};
  }
};

field::Field with_dripstone(const Dripstone& p) {
  drips::GraphOptions graph = p.graph();
  graph.run_out = false;
  graph.memory = std::numeric_limits<uint64_t>::max();  // Checked before it is computed.
  const drips::FormOptions forms = p.forms();
  const field::Traits traits{1, field::Exactness::eikonal,
                             drips::dripstone_bounds(p.field.bounds(), graph, forms), 1};
  const auto make = [rock = p.field, graph, forms] {
    return drips::forms_field(drips::forms_of(drips::build_graph(rock, graph), forms), forms);
  };
  return field::unite(
      {p.field, field::deferred(traits, "finding drips", make, drips::graph_memory(graph))},
      {field::Profile::smooth, p.root});
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(dripstone) {
  return field::field_kind<Dripstone>("dripstone", "detail", with_dripstone);
}
