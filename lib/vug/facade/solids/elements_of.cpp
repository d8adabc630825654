// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/carve.h>
#include <vug/field/affine.h>

#include <fmt/format.h>

namespace vug::facade {
namespace {

struct ElementsOf : FacadeParams {
  std::vector<std::string> kinds;
  double behind = 0.5;
  double before = 0.5;

  static void describe(Schema<ElementsOf>& s) {
    s.doc(
        "Boxes around a facade's elements of given kinds, for masks and counts: a separate "
        "material "
        "for windows is near(elements_of(front, \"window\"), from: 1cm).");
    describe_facade(s);
    s.param("kinds", &ElementsOf::kinds,
            {.doc = "names of kinds, or of lets that the rules use, in quotes", .required = true})
        .param("behind", &ElementsOf::behind,
               positive_length("extent of a box behind the element's plane"))
        .param("before", &ElementsOf::before, positive_length("extent of a box in front of it"));
    describe_frame(s);
  }
  std::string fault() const {
    if (const std::string none = facade_fault(); !none.empty()) return none;
    for (const std::string& kind : kinds)
      if (!has(kind))
        return fmt::format("the facade '{}' has no element '{}'", placed().tree->name, kind);
    return "";
  }
  bool has(const std::string& kind) const {
    if (find_kind(elements(), kind)) return true;  // may occur with another seed
    const FacadeInstance facade_here = placed();
    for (const Node& node : facade_here.tree->nodes)
      if (node.element && node.symbol == kind) return true;
    return false;
  }
};

field::Field elements_field(const ElementsOf& e) {
  const FacadeInstance placed = e.placed();
  return field::transformed(zones(*placed.tree, e.kinds, e.behind, e.before),
                            placed.frame.transform(placed.tree->width));
}

}  // namespace
}  // namespace vug::facade

VUG_FACADE_SOLID(elements_of) {
  return field::field_kind<ElementsOf>("elements_of", "operator", elements_field);
}
