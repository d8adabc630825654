// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

#include <algorithm>

namespace vug::paint {
namespace {

struct Least {
  std::vector<Mask> of;
  std::string fault() const { return of.empty() ? "the list of masks is empty" : ""; }

  static void describe(Schema<Least>& s) {
    s.doc("Intersection of masks: their minimum.")
        .param("of", &Least::of, {.doc = "the masks, as a list", .required = true});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(least) {
  return mask_kind<Least>("least", [](const Least& g) {
    const auto evaluate = [g](const EvalPoint& point) {
      double found = (*g.of[0])(point);
      for (size_t i = 1; i < g.of.size(); ++i) found = std::min(found, (*g.of[i])(point));
      return found;
    };
    return make_mask(evaluate, attribute_uses(g.of));
  });
}
