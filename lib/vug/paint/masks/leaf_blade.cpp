// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/leaf_params.h>

namespace vug::paint {
namespace {

struct LeafBlade : LeafParams {
  static void describe(Schema<LeafBlade>& s) {
    s.doc(
        "1 inside the outline of a leaf, 0 outside: the opacity of leaves on cards. Reads the leaf "
        "coordinates of leaf(...) meshes; 1 on other meshes.");
    describe_outline(s);
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(leaf_blade) {
  return mask_kind<LeafBlade>("leaf_blade", [](const LeafBlade& p) {
    return make_mask([outline = p.outline()](const EvalPoint& point) {
      const auto place = leaf_point(point);
      return !place || outline.contains(*place) ? 1.0 : 0.0;
    });
  });
}
