// SPDX-License-Identifier: Apache-2.0
#include <vug/field/modifier.h>

namespace vug::field {
namespace {

struct Offset {
  Field field;
  double by = 0.1;

  static void describe(Schema<Offset>& s) {
    s.doc("Grows a solid by a distance, which rounds its edges; negative distances shrink it.")
        .param("field", &Offset::field, {.doc = "the solid to grow", .required = true})
        .param("by", &Offset::by, any_length("outward displacement of its surface"));
  }

  template <class T>
  T apply(const T& value, const Point<T>&) const {
    return value - T(by);
  }
  Traits traits(const Traits& child) const {
    Traits out = child;
    out.bounds = child.bounds_below(by);
    // Distances remain exact outside a grown solid and inside a shrunk one, but not on both sides.
    out.exactness = std::max(child.exactness, Exactness::bound);
    out.growth = child.growth_rate();  // The box grew by `by / growth`, so this rate remains.
    return out;
  }
  Interval range(Interval child) const { return child - Interval(by); }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(offset) {
  return field_kind<Offset>("offset", "operator", [](const Offset& o) {
    return Field(std::make_shared<ModifierNode<Offset>>("offset", o, o.field.node()));
  });
}
