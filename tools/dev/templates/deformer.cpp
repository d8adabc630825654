//@ lib/vug/field/deformers, name unique in the module
// SPDX-License-Identifier: Apache-2.0
// STUB: the map from a point to the child's space, and its Lipschitz constant.
#include <vug/field/deformer.h>

namespace vug::field {
namespace {

struct NewKind {
  Field field;
  Vec3d by{0, 0, 0};

  static void describe(Schema<NewKind>& s) {
    s.doc("STUB: its effect on a solid, in one sentence.")
        .param("field", &NewKind::field, {.doc = "STUB: child field", .required = true})
        .param("by", &NewKind::by, any_length("STUB: distance"));
  }

  /// Maps a point to the child's space: the inverse of the deformation of the solid.
  template <class T>
  Point<T> map(const Point<T>& p) const {
    return p - constant<T>(by);
  }
  /// A ball that contains the image of a ball.
  Ball map(const Ball& ball) const { return {ball.centre - by, ball.radius}; }
  /// Factor for the child's value.
  double scale() const { return 1; }
  Traits traits(const Traits& child) const {
    Traits out = child;
    if (!out.bounds.isEmpty()) out.bounds = {child.bounds.min + by, child.bounds.max + by};
    return out;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(new_kind) {
  return field_kind<NewKind>("new_kind", "deformer", [](const NewKind& k) {
    return Field(std::make_shared<DeformerNode<NewKind>>("new_kind", k, k.field.node()));
  });
}
