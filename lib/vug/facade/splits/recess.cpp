// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/split.h>

namespace vug::facade {
namespace {

struct Recess {
  double depth = 0;
  PartRef part;
  std::optional<PartRef> front;

  static void describe(Schema<Recess>& s) {
    s.doc(
         "A part whose plane lies behind the wall's plane: recess(2m, Back), optionally with "
         "another "
         "part in front of it in the wall's plane: recess(2m, Back, front: Columns).")
        .param("depth", &Recess::depth,
               {.doc = "distance between both planes",
                .dimension = Dimension::length,
                .min = 0,
                .above_min = true,
                .required = true})
        .param("part", &Recess::part, {.doc = "the part in that plane", .required = true})
        .param("front", &Recess::front, {.doc = "the part in front of it in the wall's plane"});
  }

  Layout layout(double width, double height, FreeNumbers&) const {
    const Rect all{0, 0, width, height};
    Layout out;
    out.cells.push_back({.part = part.part, .rect = all, .depth = -depth});
    if (front) out.cells.push_back({.part = front->part, .rect = all});
    out.numbers = {{"depth", depth}};
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(recess) { return split_kind<Recess>("recess"); }
