// SPDX-License-Identifier: Apache-2.0
// Names of `where` in rules: the same words as with their expressions written out.
#include "samples.h"

namespace vug::lsystem {
namespace {

TEST(Locals, AreReplacedInAllPartsOfARule) {
  const SystemPtr named = system_of(
      "axiom A(1, 2)\n"
      "A(x, y) @ weight if keeps -> F(half)A(y, 2 * half) where half = (x + y) / 2,\n"
      "    keeps = half < 9, weight = 1 + half\n"
      "A(x, y) -> nothing");
  const SystemPtr plain = system_of(
      "axiom A(1, 2)\n"
      "A(x, y) @ 1 + (x + y) / 2 if (x + y) / 2 < 9 -> F((x + y) / 2)A(y, 2 * ((x + y) / 2))\n"
      "A(x, y) -> nothing");
  ASSERT_TRUE(named && plain);
  for (const int steps : {1, 3, 9}) EXPECT_EQ(after(*named, steps), after(*plain, steps));
  EXPECT_EQ(after(*named, 1), "F(1.5)A(2,3)");
}

TEST(Locals, MayFollowOnTheNextLineBeforeASign) {
  const SystemPtr system = system_of(
      "axiom A(1)+A(2)\n"
      "A(x) -> F(y)[+(turn)A(y)]\n"
      "    where y = x * 2, turn = 90deg\n"
      "+ -> -");
  ASSERT_TRUE(system);
  EXPECT_EQ(system->productions.size(), 2u);
  EXPECT_EQ(after(*system, 1), "F(2)[+(1.5707963267948966)A(2)]-F(4)[+(1.5707963267948966)A(4)]");
}

TEST(Locals, AModuleMayBeCalledWhere) {
  const SystemPtr system = system_of("axiom where A\n where -> B\n A -> where F");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 2), "BBF");
}

}  // namespace
}  // namespace vug::lsystem
