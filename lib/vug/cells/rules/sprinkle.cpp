// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>
#include <vug/cells/selection.h>

#include <algorithm>

namespace vug::cells {
namespace {

struct Sprinkle : CellSelection {
  static constexpr bool kSingleStep = true;
  Sprinkle() : CellSelection{0.5, 0} {}

  std::string attribute;
  double value = 1;
  double radius = 0;
  bool whole = false;

  static void describe(Schema<Sprinkle>& s) {
    s.doc(
         "Sets an attribute in randomly chosen cells, as a typical initial state; for a single "
         "step.")
        .param("attribute", &Sprinkle::attribute,
               {.doc = "name of the attribute", .required = true})
        .param("value", &Sprinkle::value, {.doc = "value that it gets"})
        .param("radius", &Sprinkle::radius,
               {.doc = "cells within this distance of a chosen one also get the value",
                .dimension = Dimension::length,
                .min = 0})
        .param("whole", &Sprinkle::whole, {.doc = "the attribute contains whole numbers"});
    describe_selection(s);
  }

  void step(Pass& pass) const { whole ? set<int32_t>(pass) : set<float>(pass); }

 private:
  template <class T>
  void set(Pass& pass) const {
    const auto a = pass.writes<T>(attribute);
    const Links none;
    const Links& around = radius > 0 ? pass.within(radius) : none;
    const auto chosen = [&](uint32_t i) {
      return pass.random(i).uniform() < at(pass.network(), i);
    };
    pass.run([&](const auto&, uint32_t i) {
      bool meant = chosen(i);
      if (radius > 0 && !meant) {
        const auto row = around.of(i);
        meant = std::any_of(row.begin(), row.end(), chosen);
      }
      a.set(i, meant ? static_cast<T>(value) : a[i]);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(sprinkle) { return rule_kind<Sprinkle>("sprinkle"); }
