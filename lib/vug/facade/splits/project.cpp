// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/split.h>

namespace vug::facade {
namespace {

struct Project {
  double depth = 0;
  PartRef part;

  static void describe(Schema<Project>& s) {
    s.doc("A part whose plane lies in front of the wall's plane: project(40cm, Middle).")
        .param("depth", &Project::depth,
               {.doc = "distance between both planes",
                .dimension = Dimension::length,
                .min = 0,
                .above_min = true,
                .required = true})
        .param("part", &Project::part, {.doc = "the part in that plane", .required = true});
  }

  Layout layout(double width, double height, FreeNumbers&) const {
    const Rect all{0, 0, width, height};
    Layout out;
    out.cells.push_back({.part = part.part, .rect = all, .depth = depth});

    out.numbers = {{"depth", depth}};
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(project) { return split_kind<Project>("project"); }
