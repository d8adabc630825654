// SPDX-License-Identifier: Apache-2.0
// The passages of a network as a solid.
#include <vug/shot/passage_params.h>

namespace vug::shot {
namespace {

struct Passages : PassageParams {
  static void describe(Schema<Passages>& s) {
    s.doc(
        "The air of the passages of a network, to be subtracted from rock. Sizes come from splays "
        "or from distances to the walls where the network has them.");
    describe_network(s);
    describe_walls(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(passages) {
  return field::field_kind<Passages>("passages", "passage", [](const Passages& p) {
    return passages::passages(*p.of, p.options());
  });
}
