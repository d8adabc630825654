//@ tests/unit/render
// What is known of new_kind in closed form; the tests of every kind loop over the registry by
// themselves (chi-square of its samples, furnace).
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

TEST(NewKind, IsMadeWithItsDefaults) { EXPECT_NE(make_material("new_kind"), nullptr); }

}  // namespace
}  // namespace vug::render
