// SPDX-License-Identifier: Apache-2.0
// A union of rotated copies: correct wherever the solid lies, even across the borders of its
// sector, and pruning keeps only the few copies that matter at a point.
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct PolarRepeat {
  Field field;
  int count = 6;
  Vec3d axis{0, 1, 0};

  static void describe(Schema<PolarRepeat>& s) {
    s.doc("Copies of a solid at equal angles about an axis through the origin.")
        .param("field", &PolarRepeat::field, {.doc = "the solid to repeat", .required = true})
        .param("count", &PolarRepeat::count,
               {.doc = "copies in a full turn", .min = 1, .max = 1000})
        .param("axis", &PolarRepeat::axis, {.doc = "direction of the axis, of any length but 0"});
  }
  std::string fault() const { return axis.length2() > 0 ? "" : "the axis must not be zero"; }
};

Field polar_repeated(const PolarRepeat& r) {
  std::vector<Field> copies;
  for (int i = 0; i < r.count; ++i)
    copies.push_back(
        i == 0 ? r.field
               : transformed(r.field, Transform::rotation(r.axis, 2 * kPi * i / r.count)));
  return unite(std::move(copies));
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(polar_repeat) {
  return field_kind<PolarRepeat>("polar_repeat", "deformer", polar_repeated);
}
