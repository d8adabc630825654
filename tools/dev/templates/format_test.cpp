//@ tests/unit/mesh
// SPDX-License-Identifier: Apache-2.0
// Tests of new_kind alone; the tests of all formats loop over the registry by themselves.
#include <vug/mesh/format.h>

#include <gtest/gtest.h>

namespace vug::mesh {
namespace {

TEST(NewKind, ReadsATriangle) {
  const Format& format = format_of("x.new_kind");
  const Mesh mesh = format.read("v 0 0 0\nv 1 0 0\nv 0 1 0\nt 0 1 2\n", "x.new_kind");
  EXPECT_EQ(mesh.positions.size(), 3U);
  EXPECT_EQ(mesh.triangles.size(), 1U);
}

}  // namespace
}  // namespace vug::mesh
