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
    s.doc("A sunk field within a margin, or a raised one where the depth is below 0.")
        .param("depth", &Panel::depth, any_length("of the field behind the face"))
        .param("margin", &Panel::margin,
               {.doc = "around the field", .dimension = Dimension::length, .min = 0})
        .choice("head", &Panel::head,
                {{"flat", Head::flat},
                 {"segmental", Head::segmental},
                 {"round", Head::round},
                 {"pointed", Head::pointed}},
                "how the field ends above");
  }
  std::string fault() const { return depth == 0 ? "a panel's depth is not 0" : ""; }

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
