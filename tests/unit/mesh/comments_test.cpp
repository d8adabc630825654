// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/format.h>
#include <vug/mesh/shapes.h>

#include <gtest/gtest.h>

#include <sstream>

namespace vug::mesh {
namespace {

Comments awkward() {
  Comments notes;
  notes.space = "centimetres, z up";
  notes.texts = {
      {"vug:recipe", "seed 3\n\n  a \\n | # b\r\n" + std::string(1000, 'x') + "\\\n end"},
      {"vug:empty", ""},
      {"vug:seed", "3"},
      {"vug:blank", " two  "}};
  return notes;
}

TEST(Comments, AreReadBackFromEveryTextFormat) {
  const Mesh cube = box_mesh(Box3d(Vec3d(0.0), Vec3d(1.0)));
  for (const Format* format : formats()) {
    std::string bytes;
    format->write(cube, awkward(), [&](std::string_view more) { bytes += more; });
    EXPECT_NE(bytes.find("centimetres, z up"), std::string::npos) << format->info.name;
    // The mesh is the same whatever the comments contain.
    const Mesh again = format->read(bytes, "t");
    EXPECT_EQ(bounds(again).size(), Vec3d(1.0)) << format->info.name;
    EXPECT_EQ(again.triangles.size(), 12u) << format->info.name;
    if (format->info.name == "stl") continue;  // STL has room for only 80 characters.
    EXPECT_EQ(read_comments(bytes), awkward().texts) << format->info.name;
  }
}

TEST(Comments, LinesAreShort) {
  std::istringstream lines(comment_lines(awkward(), "comment "));
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 250u);
}

TEST(Comments, FilesOfOtherProgramsHaveNone) {
  EXPECT_TRUE(read_comments("").empty());
  EXPECT_TRUE(read_comments("# Blender v3.4\n# a |b\nv 0 0 0\n# x |y|\n").empty());
  EXPECT_TRUE(read_comments("ply\nformat ascii 1.0\ncomment a b c\nend_header\n").empty());
}

}  // namespace
}  // namespace vug::mesh
