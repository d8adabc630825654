//@ tests/unit/field
// SPDX-License-Identifier: Apache-2.0
// Oracles of new_kind in closed form; the tests of every kind loop over the registry by themselves.
#include <vug/field/registry.h>

#include <gtest/gtest.h>

namespace vug::field {
namespace {

TEST(NewKind, OfASphere) {
  const Field ball = make("sphere", {{"radius", 2.0}});
  const Field f = make("new_kind", {{"field", as_value(ball)}, {"by", Vec3d(3, 0, 0)}});
  EXPECT_EQ(f.value({3, 0, 0}), -2);
  EXPECT_EQ(f.value({3, 2, 0}), 0);
}

}  // namespace
}  // namespace vug::field
