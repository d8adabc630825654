// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/leaf_params.h>

namespace vug::flora {
namespace {

struct Leaf : LeafParams {
  static void describe(Schema<Leaf>& s) {
    s.doc(
        "A lanceolate leaf with its base at the origin, its midrib along y and its face towards "
        "z.");
    describe_leaf(s);
  }
};

}  // namespace
}  // namespace vug::flora

VUG_SHAPE_KIND(leaf) {
  return shape_kind<Leaf>("leaf", [](const Leaf& p) { return leaf(p.options()); });
}
