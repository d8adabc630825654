// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rules/life_like.h>

namespace vug::cells {
namespace {

struct Maze : LifeLike {
  Maze() { birth = {3}, survive = {2, 3, 4}; }

  static void describe(Schema<Maze>& s) {
    s.doc("Walls of a maze (alive: 1 or 0), from any initial state.").cite("gobron2006");
    describe_life(s);
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(maze) { return rule_kind<Maze>("maze"); }
