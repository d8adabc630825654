// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

#include <algorithm>

namespace vug::paint {
namespace {

struct Greatest {
  std::vector<Mask> of;
  std::string fault() const { return of.empty() ? "the list of masks is empty" : ""; }

  static void describe(Schema<Greatest>& s) {
    s.doc("Union of masks: their maximum.")
        .param("of", &Greatest::of, {.doc = "the masks, as a list", .required = true});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(greatest) {
  return mask_kind<Greatest>("greatest", [](const Greatest& g) {
    const auto evaluate = [g](const EvalPoint& point) {
      double found = (*g.of[0])(point);
      for (size_t i = 1; i < g.of.size(); ++i) found = std::max(found, (*g.of[i])(point));
      return found;
    };
    return make_mask(evaluate, attribute_uses(g.of));
  });
}
