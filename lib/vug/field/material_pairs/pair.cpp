// SPDX-License-Identifier: Apache-2.0
#include <vug/field/material_pair_kind.h>

namespace vug::field {
namespace {

struct PairParams : MaterialPair {
  static void describe(Schema<PairParams>& s) {
    s.doc("The radius of the blend where two rock materials meet, for union_by_material.")
        .param("of", &MaterialPair::of,
               {.doc = "the names of the two materials, e.g. [\"limestone\", \"calcite\"]",
                .required = true})
        .param("radius", &MaterialPair::radius,
               {.doc = "the solids blend where their distances differ by less than this",
                .dimension = Dimension::length,
                .min = 0,
                .required = true});
  }
  std::string fault() const {
    return of.size() == 2 ? "" : "a pair needs two names, e.g. of: [\"limestone\", \"limestone\"]";
  }
};

}  // namespace
}  // namespace vug::field

VUG_MATERIAL_PAIR_KIND(pair) {
  return make_kind<MaterialPair, PairParams>("pair", "material pair",
                                             [](const PairParams& p) -> MaterialPair { return p; });
}
