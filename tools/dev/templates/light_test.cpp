//@ tests/unit/render
// SPDX-License-Identifier: Apache-2.0
// Closed-form tests of new_kind; the tests of all kinds loop over the registry by themselves
// (chi-square of the samples, furnace).
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

TEST(NewKind, IsMadeWithItsDefaults) { EXPECT_NE(make_light("new_kind"), nullptr); }

}  // namespace
}  // namespace vug::render
