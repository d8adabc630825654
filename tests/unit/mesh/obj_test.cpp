// SPDX-License-Identifier: Apache-2.0
#include "faults.h"

#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

namespace vug::mesh {
namespace {

Mesh read_obj_text(const std::string& text) { return format_of("x.obj").read(text, "x.obj"); }

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

double area_along_z(const Mesh& mesh) {
  double sum = 0;
  for (size_t face = 0; face < mesh.triangles.size(); ++face)
    sum += double_area_vector(mesh, face).z / 2;
  return sum;
}

TEST(Obj, ReadsEveryFormOfCorner) {
  for (const char* face :
       {"f 1 2 3 4", "f 1/1 2/1 3/1 4/1", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/1/1 3/1/1 4/1/1",
        "f -4 -3 -2 -1", "f -4/-1/-1 -3/-1/-1 -2/-1/-1 -1/-1/-1", "f 1 2 \\\n 3 4 # done",
        "\tf  1/ 2/ 3/ 4/\r"}) {
    SCOPED_TRACE(face);
    const Mesh mesh = read_obj_text(std::string("mtllib a.mtl\n") + kSquare +
                                    "vt 0 0\nvn 0 0 1\ng side\n" + face + "\n");
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_DOUBLE_EQ(area_along_z(mesh), 1);
  }
}

TEST(Obj, KeepsNormalsWhereEachVertexHasOne) {
  const std::string points = std::string(kSquare) + "vn 0 0 1\nvn 0 1 0\nvn 0 0 1\n";
  EXPECT_EQ(read_obj_text(points + "f 1//1 2//1 3//1\nf 1//3 3//1 4//1\n").normals.size(), 4U);
  EXPECT_TRUE(read_obj_text(points + "f 1//1 2//1 3//1\nf 1//2 3//1 4//1\n").normals.empty());
  EXPECT_TRUE(read_obj_text(points + "f 1//1 2//1 3//1\n").normals.empty());
}

TEST(Obj, ReadsVertexColours) {
  const Mesh mesh = read_obj_text("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1\nv 0 1 0\nf 1 2 3\n");
  const Attribute* colour = find_attribute(mesh, kColour, 3);
  ASSERT_NE(colour, nullptr);
  EXPECT_EQ(colour->values, (std::vector<float>{1, 0.5F, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(Obj, ConcavePolygonsStayConcave) {
  // An arrowhead whose fan from the first corner would cover the concavity.
  const Mesh mesh = read_obj_text("v 0 0 0\nv 2 -2 0\nv 0.5 0 0\nv 2 2 0\nf 2 3 4 1\n");
  EXPECT_DOUBLE_EQ(area_along_z(mesh), 1);
  for (size_t face = 0; face < mesh.triangles.size(); ++face)
    EXPECT_GT(double_area_vector(mesh, face).z, 0);
  const Mesh comb = read_obj_text(
      "v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\n"
      "v 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n");
  EXPECT_EQ(comb.triangles.size(), 10U);
  EXPECT_DOUBLE_EQ(area_along_z(comb), 11);
  for (size_t face = 0; face < comb.triangles.size(); ++face)
    EXPECT_GT(double_area_vector(comb, face).z, 0);
}

TEST(Obj, FaultsNameTheirLine) {
  expect_faults("obj", {
                           {"v 0 0\n", 1, "3 coordinates"},
                           {"v 0 0 0\nv 1 0 x\n", 2, "'x' is not a number"},
                           {"v 0 0 nan\n", 1, "not a finite number"},
                           {"v 0 0 1e999\n", 1, "too large"},
                           {"v 0 0 1e39\n", 1, "single precision"},
                           {"v 0 0 0\nf 1 2 3\n", 2, "unknown vertex 2: there are 1 so far"},
                           {"v 0 0 0\n\nf 0 1 1\n", 3, "unknown vertex 0"},
                           {"v 0 0 0\nf -2 1 1\n", 2, "unknown vertex -2"},
                           {"v 0 0 0\nf 1//1 1 1\n", 2, "unknown normal 1"},
                           {"v 0 0 0\nf 1 1\n", 2, "at least 3 corners"},
                           {"v 0 0 0\nf 1 1 1.5\n", 2, "not an integer"},
                           {"v 0 0 0\nhello\n", 2, "unknown OBJ statement 'hello'"},
                           {"# nothing\n", 2, "no vertex"},
                       });
}

}  // namespace
}  // namespace vug::mesh
