// SPDX-License-Identifier: Apache-2.0
#include <vug/field/modifier.h>

namespace vug::field {
namespace {

struct Shell {
  Field field;
  double thickness = 0.1;

  static void describe(Schema<Shell>& s) {
    s.doc("A shell around the surface of a solid, half of it on each side.")
        .param("field", &Shell::field, {.doc = "the solid to hollow out", .required = true})
        .param("thickness", &Shell::thickness, positive_length("thickness of the shell"));
  }

  template <class T>
  T apply(const T& value, const Point<T>&) const {
    return abs(value) - T(0.5 * thickness);
  }
  Traits traits(const Traits& child) const {
    Traits out = child;
    out.bounds = child.bounds_below(0.5 * thickness);
    out.exactness = std::max(child.exactness, Exactness::bound);
    out.growth = child.growth_rate();
    return out;
  }
  Interval range(Interval child) const { return abs(child) - Interval(0.5 * thickness); }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(shell) {
  return field_kind<Shell>("shell", "operator", [](const Shell& o) {
    return Field(std::make_shared<ModifierNode<Shell>>("shell", o, o.field.node()));
  });
}
