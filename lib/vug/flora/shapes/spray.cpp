// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/leaf_params.h>

namespace vug::flora {
namespace {

struct Spray : LeafParams {
  int leaves = SprayOptions().leaves;
  double angle = SprayOptions().angle;
  double spacing = SprayOptions().spacing;
  double vary = SprayOptions().vary;
  int seed = 0;

  static void describe(Schema<Spray>& s) {
    s.doc("Leaves in two rows at the end of a twig that starts at the origin along y.")
        .param("leaves", &Spray::leaves, {.doc = "how many", .min = 1, .max = 1000})
        .param("angle", &Spray::angle,
               {.doc = "between the twig and its lateral leaves",
                .dimension = Dimension::angle,
                .min = 0,
                .max = kPi})
        .param("spacing", &Spray::spacing, positive_length("along the twig from leaf to leaf"))
        .param("vary", &Spray::vary,
               {.doc = "relative variation of lengths, angles and bends", .min = 0, .max = 1})
        .param("seed", &Spray::seed, {.doc = "another number, another spray", .min = 0});
    describe_leaf(s);
  }
};

mesh::Mesh make_spray(const Spray& p) {
  return spray({p.options(), p.leaves, p.angle, p.spacing, p.vary,
                RandomKey(static_cast<uint64_t>(p.seed)).at("spray")});
}

}  // namespace
}  // namespace vug::flora

VUG_SHAPE_KIND(spray) { return shape_kind<Spray>("spray", make_spray); }
