//@ tests/unit/field
// SPDX-License-Identifier: Apache-2.0
// Oracles of new_kind in closed form; the tests of every kind loop over the registry by themselves.
#include <vug/field/registry.h>

#include <gtest/gtest.h>

namespace vug::field {
namespace {

TEST(NewKind, DistancesOnTheAxes) {
  const Field f = make("new_kind", {{"radius", 2.0}});
  EXPECT_EQ(f.value({0, 0, 0}), -2);
  EXPECT_EQ(f.value({2, 0, 0}), 0);
  EXPECT_EQ(f.value({0, 0, -5}), 3);
}

}  // namespace
}  // namespace vug::field
