// SPDX-License-Identifier: Apache-2.0
// The height above the floors of the passages of a network.
#include <vug/passages/lines/height_above_floor.h>
#include <vug/shot/passage_line.h>

namespace vug::shot {
namespace {

struct HeightAboveFloor : PassageLine {
  static void describe(Schema<HeightAboveFloor>& s) {
    s.doc(
         "The height above the lowest points of the nearest passage of a network, for flood lines, "
         "moss or sediment. In shafts, it is the height above the axis at the nearest point of it.")
        .cite("mcshane1934extension");
    describe_network(s);
    describe_axes(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(height_above_floor) {
  return field::field_kind<HeightAboveFloor>(
      "height_above_floor", "passage", [](const HeightAboveFloor& p) {
        return passages::height_above_floor(passages::axis_lines(*p.of, p.options()));
      });
}
