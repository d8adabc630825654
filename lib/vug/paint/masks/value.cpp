// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct AttributeValue {
  std::string name;
  double scale = 1;
  double otherwise = 0;

  static void describe(Schema<AttributeValue>& s) {
    s.doc("The value of a mesh or cell attribute; colours are averaged.")
        .param("name", &AttributeValue::name, {.doc = "the attribute's name", .required = true})
        .param("scale", &AttributeValue::scale, {.doc = "factor of the number"})
        .param("otherwise", &AttributeValue::otherwise,
               {.doc = "value on a mesh without the attribute"});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(value) {
  return attribute_mask_kind<AttributeValue>(
      "value", [](const AttributeValue& a, AttributeUses uses) {
        const auto evaluate = [a](const EvalPoint& point) {
          const auto value = point.attributes ? point.attributes->read(a.name) : std::nullopt;
          return value ? a.scale * (value->x + value->y + value->z) / 3 : a.otherwise;
        };
        return make_mask(evaluate, std::move(uses));
      });
}
