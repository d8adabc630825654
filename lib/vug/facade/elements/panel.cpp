// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/field/boolean.h>

#include <algorithm>

namespace vug::facade {
namespace {

struct Panel {
  double depth = 0.04;
  double margin = 0.1;
  Head head = Head::flat;

  static void describe(Schema<Panel>& s) {
    s.doc("A sunk field within a margin, or a raised one if the depth is negative.")
        .param("depth", &Panel::depth, any_length("depth of the field behind the face"))
        .param("margin", &Panel::margin,
               {.doc = "margin around the field", .dimension = Dimension::length, .min = 0})
        .choice("head", &Panel::head,
                {{"flat", Head::flat},
                 {"segmental", Head::segmental},
                 {"round", Head::round},
                 {"pointed", Head::pointed}},
                "shape of the field's top");
  }
  std::string fault() const { return depth == 0 ? "the depth of a panel must not be 0" : ""; }

  Solids solids(double width, double height) const {
    Solids out;
    const Rect field{margin, margin, width - 2 * margin, height - 2 * margin};
    (depth > 0 ? out.cut : out.add)
        .push_back(arched_block(field, head, 0, depth > 0 ? -depth : -0.05,
                                depth > 0 ? kCutMargin : -depth));
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(panel) { return element_kind<Panel>("panel"); }
