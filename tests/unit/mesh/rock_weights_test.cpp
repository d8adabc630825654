// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/rock_weights.h>
#include <vug/mesh/shapes.h>

#include <gtest/gtest.h>

#include <set>

namespace vug::mesh {
namespace {

/// A sphere with weights that change over `width` at height 0.
Mesh two_rocks(float width) {
  Mesh mesh = sphere_mesh({0, 0, 0}, 1, 4);
  Attribute shale{"w_shale", 1, {}}, limestone{"w_limestone", 1, {}};
  for (const Vec3f& p : mesh.positions) {
    const float share = std::min(1.0f, std::max(0.0f, 0.5f + p.y / width));
    shale.values.push_back(share);
    limestone.values.push_back(1 - share);
  }
  mesh.attributes = {{"flow", 1, std::vector<float>(mesh.positions.size())}, shale, limestone};
  return mesh;
}

TEST(RockWeights, NamesAreThoseOfTheAttributes) {
  const Mesh mesh = two_rocks(0.1f);
  EXPECT_EQ(rock_materials(mesh), (std::vector<std::string>{"limestone", "shale"}));
  EXPECT_EQ(weight_attribute("clay"), "w_clay");
  EXPECT_EQ(material_of_attribute("w_clay"), "clay");
  EXPECT_FALSE(material_of_attribute("w_"));
  EXPECT_FALSE(material_of_attribute("wet"));
}

// Every triangle has one material, and materials change only at triangles that touch the contact.
TEST(RockWeights, TheLargestSumOfTheCornersDecides) {
  const Mesh mesh = two_rocks(0.1f);
  const std::vector<int32_t> faces = face_materials(mesh, rock_materials(mesh));
  ASSERT_EQ(faces.size(), mesh.triangles.size());
  for (size_t face = 0; face < faces.size(); ++face) {
    int above = 0;
    for (const uint32_t corner : mesh.triangles[face]) above += mesh.positions[corner].y > 0;
    if (above == 0) {
      EXPECT_EQ(faces[face], 0);
    }
    if (above == 3) {
      EXPECT_EQ(faces[face], 1);
    }
  }
  EXPECT_EQ(std::set<int32_t>(faces.begin(), faces.end()), (std::set<int32_t>{0, 1}));
  EXPECT_EQ(face_materials(mesh, {"clay"}), std::vector<int32_t>(faces.size(), -1));
}

}  // namespace
}  // namespace vug::mesh
