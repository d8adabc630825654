//@ lib/vug/field/primitives, name unique in the module
// SPDX-License-Identifier: Apache-2.0
// STUB: the formula of the distance and its source, e.g. |p| - r.
#include <vug/field/primitive.h>

namespace vug::field {
namespace {

struct NewKind {
  double radius = 1;

  static void describe(Schema<NewKind>& s) {
    s.doc("STUB: the solid, in one sentence.")
        .param("radius", &NewKind::radius, positive_length("STUB: the measured radius"));
  }
  /// Signed distance in metres, negative inside. T is any of the number types: use their functions
  /// only.
  template <class T>
  T distance(const Point<T>& p) const {
    return length(p) - T(radius);
  }
  Box3d bounds() const { return {Vec3d(-radius), Vec3d(radius)}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(new_kind) { return primitive_kind<NewKind>("new_kind"); }
