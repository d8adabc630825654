// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/mesh/mesh.h>

#include <gtest/gtest.h>

#include <limits>

namespace vug::mesh {
namespace {

Mesh one_triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.attributes = {{"Cd", 3, std::vector<float>(9, 0.5F)}};
  return mesh;
}

TEST(Mesh, AreaVectorPointsOutOfAnAnticlockwiseTriangle) {
  EXPECT_EQ(double_area_vector(one_triangle(), 0), Vec3d(0, 0, 6));
}

TEST(Mesh, DigestDependsOnEveryMember) {
  const Mesh mesh = one_triangle();
  const Digest base = digest(mesh);
  EXPECT_EQ(digest(Mesh(mesh)), base);
  Mesh moved = mesh;
  moved.positions[1].x = 1;
  EXPECT_NE(digest(moved), base);
  Mesh turned = mesh;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_NE(digest(turned), base);
  Mesh painted = mesh;
  painted.attributes[0].values[4] = 1;
  EXPECT_NE(digest(painted), base);
  Mesh lit = mesh;
  lit.normals.assign(3, Vec3f(0, 0, 1));
  EXPECT_NE(digest(lit), base);
}

TEST(Mesh, ValidateRefusesInvalidMeshes) {
  EXPECT_NO_THROW(validate(one_triangle(), "test"));
  Mesh mesh = one_triangle();
  mesh.triangles[0][2] = 3;
  EXPECT_THROW(validate(mesh, "test"), Error);
  mesh = one_triangle();
  mesh.positions[2].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(validate(mesh, "test"), Error);
  mesh = one_triangle();
  mesh.attributes[0].values.pop_back();
  EXPECT_THROW(validate(mesh, "test"), Error);
  mesh = one_triangle();
  mesh.normals.resize(2);
  EXPECT_THROW(validate(mesh, "test"), Error);
}

TEST(Mesh, BoundsOfNothingAreEmpty) {
  EXPECT_TRUE(bounds(Mesh{}).isEmpty());
  EXPECT_EQ(bounds(one_triangle()), Box3d(Vec3d(0), Vec3d(2, 3, 0)));
}

}  // namespace
}  // namespace vug::mesh
