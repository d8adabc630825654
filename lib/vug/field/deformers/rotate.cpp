// SPDX-License-Identifier: Apache-2.0
#include <vug/field/affine.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Rotate {
  Field field;
  double angle = 0;
  Vec3d axis{0, 1, 0};
  Vec3d pivot{0, 0, 0};

  static void describe(Schema<Rotate>& s) {
    s.doc("Rotates a solid about an axis, counter-clockwise as seen from the tip of the axis.")
        .param("field", &Rotate::field, {.doc = "the solid to rotate", .required = true})
        .param("angle", &Rotate::angle,
               {.doc = "angle of the rotation", .dimension = Dimension::angle, .required = true})
        .param("axis", &Rotate::axis, {.doc = "direction of the axis, of any length but 0"})
        .param("pivot", &Rotate::pivot, any_length("a point on the axis"));
  }
  std::string fault() const { return axis.length2() > 0 ? "" : "the axis must not be zero"; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(rotate) {
  using vug::Transform;
  return field_kind<Rotate>("rotate", "deformer", [](const Rotate& r) {
    return transformed(r.field, Transform::translation(r.pivot) *
                                    Transform::rotation(r.axis, r.angle) *
                                    Transform::translation(-r.pivot));
  });
}
