// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rules/life_like.h>

namespace vug::cells {
namespace {

struct Life : LifeLike {
  Life() { birth = {3}, survive = {2, 3}; }

  static void describe(Schema<Life>& s) {
    s.doc("The game of life (alive: 1 or 0), or another automaton of this type.")
        .cite("gardner1970");
    describe_life(s);
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(life) { return rule_kind<Life>("life"); }
