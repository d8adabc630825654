//@ lib/vug/field/operators, name unique in the module
// SPDX-License-Identifier: Apache-2.0
// STUB: the formula, and how exact the resulting distance is.
#include <vug/field/modifier.h>

namespace vug::field {
namespace {

struct NewKind {
  Field field;
  double by = 0.1;

  static void describe(Schema<NewKind>& s) {
    s.doc("STUB: its effect on a solid, in one sentence.")
        .param("field", &NewKind::field, {.doc = "STUB: child field", .required = true})
        .param("by", &NewKind::by, any_length("STUB: distance"));
  }

  /// The new value for the child's `value`; T is any of the number types.
  template <class T>
  T apply(const T& value, const Point<T>&) const {
    return value - T(by);
  }
  /// The guarantees for the new values, derived from those of the child.
  Traits traits(const Traits& child) const {
    Traits out = child;
    out.bounds = child.bounds_below(by);
    out.exactness = std::max(child.exactness, Exactness::bound);
    out.growth = child.growth_rate();
    return out;
  }
  Interval range(Interval child) const { return child - Interval(by); }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(new_kind) {
  return field_kind<NewKind>("new_kind", "operator", [](const NewKind& k) {
    return Field(std::make_shared<ModifierNode<NewKind>>("new_kind", k, k.field.node()));
  });
}
