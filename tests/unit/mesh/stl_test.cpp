// SPDX-License-Identifier: Apache-2.0
#include "faults.h"

#include <gtest/gtest.h>

namespace vug::mesh {
namespace {

Mesh read_stl_text(const std::string& text) { return format_of("x.stl").read(text, "x.stl"); }

constexpr const char* kText =
    "solid a name of several words\n"
    " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 1 1 0\n"
    "  endloop\n endfacet\n"
    " facet normal 0 0 1\n  outer loop\n   vertex -0 0 0\n   vertex 1 1 0\n   vertex 0 1e0 0\n"
    "  endloop\n endfacet\nendsolid a name\n";

TEST(Stl, TextIsReadAndWelded) {
  const Mesh mesh = read_stl_text(kText);
  EXPECT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(read_stl_text(std::string(kText) + kText).triangles.size(), 4U);
}

TEST(Stl, BinaryFilesMayBeginWithSolid) {
  std::string bytes;
  format_of("x.stl").write(read_stl_text(kText), {}, [&](std::string_view more) { bytes += more; });
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read_stl_text(bytes).triangles.size(), 2U);
}

TEST(Stl, FaultsOfTextNameTheirLine) {
  const std::string text = kText;
  expect_faults(
      "stl", {
                 {"solid\nfacet normal 0 0\n", 3, "missing"},
                 {"solid\nvertex", 2, "expected 'facet' or 'endsolid'"},
                 {text.substr(0, text.find("vertex 1 1")), 6, "ends where 'vertex' is expected"},
                 {text + "more", 17, "expected 'solid'"},
                 {"solid\nfacet normal 0 0 1 outer loop\nvertex 0 0 1e60\n", 3, "single precision"},
             });
}

}  // namespace
}  // namespace vug::mesh
