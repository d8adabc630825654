// SPDX-License-Identifier: Apache-2.0
// Still water in a hollow of a rock.
#include <vug/field/box_fault.h>
#include <vug/passages/water/fill.h>
#include <vug/shot/networks.h>

namespace vug::shot {
namespace {

struct Fill {
  field::Field field;
  std::vector<Vec3d> at;
  double level = 0;
  Vec3d from{-5, -5, -5}, to{5, 5, 5};
  double cell = 0.1;
  bool cut = false;

  static void describe(Schema<Fill>& s) {
    s.doc(
         "Still water in a hollow of a rock, up to a level. It extends into the rock, so that the "
         "rock is its bed and its shore. A leak is an error with its place.")
        .param("field", &Fill::field,
               {.doc = "the rock, which is positive in air", .required = true})
        .param("at", &Fill::at,
               {.doc = "points of the air in or above the water: each hollow needs one",
                .dimension = Dimension::length,
                .required = true})
        .param("level", &Fill::level, any_length("height of the surface"))
        .param("from", &Fill::from, any_length("corner of the region that contains the water"))
        .param("to", &Fill::to, any_length("opposite corner"))
        .param("cell", &Fill::cell,
               positive_length("edge of the cells that the water runs through: it does not pass "
                               "narrower gaps"))
        .param("cut", &Fill::cut,
               {.doc = "the faces of the region end the water instead of a leak"});
  }
  std::string fault() const {
    if (at.empty()) return "'at' needs at least one point";
    return field::box_fault(from, to);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(fill) {
  return field::field_kind<Fill>("fill", "detail", [](const Fill& p) {
    return passages::fill_body(p.field, {.at = p.at,
                                         .level = p.level,
                                         .region = Box3d(p.from, p.to),
                                         .cell = p.cell,
                                         .cut = p.cut});
  });
}
