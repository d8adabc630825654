// SPDX-License-Identifier: Apache-2.0
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Mirror {
  Field field;
  Vec3d normal{1, 0, 0};
  bool keep = true;

  static void describe(Schema<Mirror>& s) {
    s.doc(
         "The mirror image of a solid in a plane through the origin, united with the solid itself.")
        .param("field", &Mirror::field, {.doc = "the solid to mirror", .required = true})
        .param("normal", &Mirror::normal, {.doc = "normal of the plane, of any length but 0"})
        .param("keep", &Mirror::keep, {.doc = "false: only the image"});
  }
  std::string fault() const { return normal.length2() > 0 ? "" : "the normal must not be zero"; }
};

/// p - 2 (p.n) n.
Transform reflection(const Vec3d& normal) {
  const Vec3d n = normal.normalized();
  const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  return {x - 2 * n.x * n, y - 2 * n.y * n, z - 2 * n.z * n, Vec3d(0)};
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(mirror) {
  return field_kind<Mirror>("mirror", "deformer", [](const Mirror& m) {
    const Field image = transformed(m.field, reflection(m.normal));
    return m.keep ? unite({m.field, image}) : image;
  });
}
