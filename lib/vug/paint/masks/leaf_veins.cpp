// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/leaf_params.h>

namespace vug::paint {
namespace {

struct LeafVeinsMask : LeafParams {
  int count = LeafVeins().count;
  double midrib = LeafVeins().midrib;
  double cross_veins = LeafVeins().cross_veins;

  static void describe(Schema<LeafVeinsMask>& s) {
    s.doc(
         "1 on the midrib of a leaf, up to 0.5 on its veins, 0 between them and on meshes that "
         "leaf(...) did not make.")
        .param("count", &LeafVeinsMask::count,
               {.doc = "veins of each half, which run lengthwise", .min = 0, .max = 100})
        .param("midrib", &LeafVeinsMask::midrib,
               {.doc = "fraction of the width that the midrib takes", .min = 0, .max = 1})
        .param("cross_veins", &LeafVeinsMask::cross_veins,
               {.doc = "fine cross veins along its length: the chequers of bamboo",
                .min = 0,
                .max = 1000});
    describe_outline(s);
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(leaf_veins) {
  return mask_kind<LeafVeinsMask>("leaf_veins", [](const LeafVeinsMask& p) {
    const LeafVeins veins{p.count, p.midrib, p.cross_veins};
    return make_mask([outline = p.outline(), veins](const EvalPoint& point) {
      const auto place = leaf_point(point);
      return place ? vein_at(*place, outline, veins) : 0.0;
    });
  });
}
