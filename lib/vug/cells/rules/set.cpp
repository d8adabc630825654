// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>
#include <vug/paint/kind.h>

#include <cmath>

namespace vug::cells {
namespace {

struct Set {
  static constexpr bool kSingleStep = true;
  std::string attribute;
  paint::Mask to;

  static void describe(Schema<Set>& s) {
    s.doc(
         "Creates an attribute and sets it to a mask or a number; for a single step, but with "
         "`steps` it follows the attributes of the mask.")
        .param("attribute", &Set::attribute, {.doc = "name of the attribute", .required = true})
        .param("to", &Set::to, {.doc = "its value", .required = true});
  }
  paint::AttributeUses mask_attributes() const { return to->uses(); }

  void step(Pass& pass) const {
    const auto number = pass.writes<float>(attribute);
    pass.run([&](const auto&, uint32_t i) {
      const auto value = static_cast<float>(pass.evaluate(to, i));
      number.set(i, std::isfinite(value) ? value : 0);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(set) { return rule_kind<Set>("set"); }
