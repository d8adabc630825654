// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/carve.h>
#include <vug/field/affine.h>

namespace vug::facade {
namespace {

struct Infill : FacadeParams {
  static void describe(Schema<Infill>& s) {
    s.doc(
        "The infill of a facade's openings, of other materials than its wall: panes, leaves of "
        "doors, railings.");
    describe_facade(s);
    describe_frame(s);
  }
  std::string fault() const { return facade_fault(); }
};

field::Field infill_field(const Infill& i) {
  const FacadeInstance placed = i.placed();
  return with_facade(placed, field::transformed(carve(*placed.tree).fill,
                                                placed.frame.transform(placed.tree->width)));
}

}  // namespace
}  // namespace vug::facade

VUG_FACADE_SOLID(infill) { return field::field_kind<Infill>("infill", "operator", infill_field); }
