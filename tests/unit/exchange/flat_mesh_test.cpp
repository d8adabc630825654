// SPDX-License-Identifier: Apache-2.0
#include <vug/base/scratch_folder.h>
#include <vug/exchange/flat_mesh.h>
#include <vug/exchange/program.h>
#include <vug/mesh/format.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include "sample.h"

namespace vug::exchange {
namespace {

TEST(FlatMesh, ACubeOfAMetreIsOneMetreInEveryFormatAndSpace) {
  Assembly one = sample();
  one.groups.resize(1);
  for (const char* name : {"obj", "ply"})
    for (const Space& space : {Space{UpAxis::y, 1}, Space{UpAxis::z, 0.01}}) {
      const ScratchFolder scratch("vug_flat");
      const std::filesystem::path file = scratch.file(std::string("cube.") + name);
      const WriteReport written = write(format(name), one, space, file);
      const mesh::Mesh mesh = mesh::read_mesh(file);
      const Vec3d size = mesh::bounds(mesh).size() * space.metres_per_unit;
      EXPECT_LT((size - Vec3d(1.0)).length(), 1e-6) << name;
      // The cube stands on the ground, so up is never negative; y up becomes z up, so z becomes -y.
      const Box3d box = mesh::bounds(mesh);
      EXPECT_GE(space.up == UpAxis::z ? box.min.z : box.min.y, 0);
      EXPECT_LE(space.up == UpAxis::z ? box.max.y : 0, 0);
      EXPECT_EQ(written.unsupported.size(), one.cameras.size() + one.lights.size());
      const auto texts = read_metadata(file);
      ASSERT_FALSE(texts.empty());
      EXPECT_EQ(texts[0].second, one.provenance.recipe);
    }
}

TEST(FlatMesh, InstancesAreInPlaceAndMirroredOnesFaceOutwards) {
  Assembly all = sample();
  all.groups[1].places.push_back(Transform::translation({9, 0, 0}) *
                                 Transform::scaling({-1, 1, 1}));
  Prototype bare = all.prototypes[0];
  mesh::Mesh plain = *bare.mesh;
  plain.attributes.clear();
  bare.mesh = std::make_shared<const mesh::Mesh>(std::move(plain));
  bare.look.base_color = {0.1, 0.2, 0.3};
  all.prototypes.push_back(bare);
  all.groups.push_back({"bare", 1, {Transform::translation({0, 5, 0})}});
  const mesh::Mesh mesh = flat_mesh(all);
  EXPECT_NO_THROW(mesh::validate(mesh, "t"));
  EXPECT_EQ(mesh.triangles.size(), 6u * 12);
  EXPECT_LT((mesh::bounds(mesh).max - bounds(all).max).length(), 1e-6);
  double volume = 0;
  for (size_t i = 0; i < mesh.triangles.size(); ++i)
    volume += mesh::corners(mesh, i)[0].dot(mesh::double_area_vector(mesh, i)) / 6;
  EXPECT_NEAR(volume, 1 + 3 * 0.125 + 1 + 1, 1e-5);
  // Normals remain on the outside.
  const mesh::Triangle& mirrored = mesh.triangles[4 * 12];
  EXPECT_GT(Vec3d(mesh.normals[mirrored[0]]).dot(mesh::double_area_vector(mesh, 4 * 12)), 0);
  const mesh::Attribute* color = mesh::find_attribute(mesh, "Cd", 3);
  ASSERT_TRUE(color);
  EXPECT_EQ(color->values.back(), 0.3F);
  EXPECT_EQ(color->values[0], all.prototypes[0].mesh->attributes[0].values[0]);
}

}  // namespace
}  // namespace vug::exchange
