// SPDX-License-Identifier: Apache-2.0
// `smallest_piece` of a mesh: which components it removes, and that the rest is unchanged.
#include <gtest/gtest.h>
#include <vug/building/builder.h>
#include <vug/loading/load.h>
#include <vug/mesh/topology.h>

namespace vug::building {
namespace {

struct Made {
  mesh::Mesh mesh;
  size_t left_out = 0;
};

Made made(const std::string& solid, const std::string& entries) {
  const loading::Loaded loaded = loading::load_text(
      "volume rock = level_set(" + solid +
          ", voxel: 20cm)\n"
          "mesh wall on rock { paint layer(under: (1, 0, 0), over: (0, 1, 0), mask: noise()) " +
          entries + " }\n",
      "t.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  Builder builder(loaded.shot);
  const shot::MeshPtr plan = loaded.shot.meshes.at(0);
  EXPECT_EQ(builder.components_removed(plan), 0U) << "before it is made";
  return {*builder.mesh(plan), builder.components_removed(plan)};
}

const std::string kBall = "(sphere(2m) - sphere(50cm)";
const std::string kCrumb = " + sphere(40cm).translate((4, 0, 0)))";

TEST(SmallestPiece, RemovesCrumbsAndBubblesWithTheirColours) {
  const Made all = made(kBall + kCrumb, "");
  EXPECT_EQ(mesh::inspect(all.mesh).components, 3U);
  EXPECT_EQ(all.left_out, 0U);

  const Made one = made(kBall + kCrumb, "smallest_piece 2m");
  EXPECT_EQ(mesh::inspect(one.mesh).components, 1U);
  EXPECT_EQ(mesh::inspect(one.mesh).unused_vertices, 0U);
  EXPECT_EQ(one.left_out, 2U);
  EXPECT_NO_THROW(mesh::validate(one.mesh, "the mesh"));
  EXPECT_EQ(one.mesh, made("sphere(2m)", "").mesh);
}

TEST(SmallestPiece, IsZeroByDefault) {
  EXPECT_EQ(made(kBall + kCrumb, "smallest_piece 0cm").mesh, made(kBall + kCrumb, "").mesh);
}

}  // namespace
}  // namespace vug::building
