#include <vug/field/modifier.h>

namespace vug::field {
namespace {

struct Offset {
  Field field;
  double by = 0.1;

  static void describe(Schema<Offset>& s) {
    s.doc("Grows a solid by a distance, rounding its edges; shrinks it where negative.")
        .param("field", &Offset::field, {.doc = "what grows", .required = true})
        .param("by", &Offset::by, any_length("the way its surface moves outwards"));
  }

  template <class T>
  T apply(const T& value, const Point<T>&) const {
    return value - T(by);
  }
  Traits traits(const Traits& child) const {
    Traits out = child;
    out.bounds = child.bounds_below(by);
    // Outside of a grown solid distances stay true, and inside of a shrunk one: not on both sides.
    out.exactness = std::max(child.exactness, Exactness::bound);
    out.growth = child.growth_rate();  // the box grew by `by / growth`, so this much is left
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
