// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct AttributeMask {
  std::string name;
  double from = 0;
  double to = 1;
  double otherwise = 0;

  static void describe(Schema<AttributeMask>& s) {
    s.doc(
         "0 at one value of a vertex attribute of the mesh, or in a cell rule of a cell attribute, "
         "1 "
         "at another; colours are averaged.")
        .param("name", &AttributeMask::name, {.doc = "the attribute's name", .required = true})
        .param("from", &AttributeMask::from, {.doc = "value where the mask is 0"})
        .param("to", &AttributeMask::to, {.doc = "value where the mask is 1"})
        .param("otherwise", &AttributeMask::otherwise,
               {.doc = "value on a mesh without the attribute", .min = 0, .max = 1});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(attribute) {
  return attribute_mask_kind<AttributeMask>(
      "attribute", [](const AttributeMask& a, AttributeUses uses) {
        const auto evaluate = [a](const EvalPoint& point) {
          const auto value = point.attributes ? point.attributes->read(a.name) : std::nullopt;
          if (!value) return a.otherwise;
          return ramp((value->x + value->y + value->z) / 3, a.from, a.to);
        };
        return make_mask(evaluate, std::move(uses));
      });
}
