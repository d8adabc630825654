// SPDX-License-Identifier: Apache-2.0
// The layer of all tiles, and hulls of few triangles.
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/exchange/usd_tiles.h>
#include <vug/mesh/shapes.h>

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace vug::exchange {
namespace {

TEST(UsdTiles, HullsHaveFewTrianglesOnTheirVertices) {
  const mesh::Mesh fine = mesh::sphere_mesh({1, 2, 3}, 1, 5);
  std::set<std::tuple<float, float, float>> positions;
  for (const Vec3f& p : fine.positions) positions.insert({p.x, p.y, p.z});
  for (const size_t most : {16u, 64u, 1000u}) {
    const mesh::Mesh hull = coarse_hull(fine, most);
    EXPECT_NO_THROW(mesh::validate(hull, "t"));
    EXPECT_LE(hull.triangles.size(), most);
    EXPECT_GE(hull.triangles.size(), most / 4);
    for (const Vec3f& p : hull.positions) EXPECT_EQ(positions.count({p.x, p.y, p.z}), 1u);
  }
  // Nothing remains of so few triangles but the box.
  EXPECT_EQ(coarse_hull(fine, 0).triangles.size(), 12u);
  EXPECT_TRUE(coarse_hull(mesh::Mesh(), 64).triangles.empty());
  const mesh::Mesh few = mesh::sphere_mesh({1, 2, 3}, 1, 0);
  EXPECT_TRUE(coarse_hull(few, few.triangles.size()) == few);
  EXPECT_TRUE(coarse_hull(few, 64) == few);
}

TEST(UsdTiles, NamesArePrimsAndLevelsAreVariants) {
  const ScratchFolder scratch("vug_usd_tiles");
  const mesh::Mesh hull = mesh::box_mesh(Box3d(Vec3d(0.25), Vec3d(0.5)));
  const Box3d box(Vec3d(0.0), Vec3d(1.0));
  const std::vector<UsdTile> tiles = {
      {"rock_-1_0_2", box, {{"rock_-1_0_2.usda", 0}, {"rock_-1_0_2_lod1.usda", 0.125}}, hull},
      {"leaf", box, {{"leaf_whole.usda", 0}}, hull}};
  const std::filesystem::path file = scratch.path() / "assembly.usda";
  write_usd_tiles("my cave", tiles, {"volume a = level_set(sphere(1m))\n", 7, 1, "0"}, file);
  const std::string text = read_text(file);
  const auto has = [&](const std::string& what) { return text.find(what) != std::string::npos; };
  EXPECT_TRUE(has("defaultPrim = \"my_cave\""));
  EXPECT_TRUE(has("def Xform \"rock__1_0_2\" ("));
  EXPECT_TRUE(has("prepend payload = @./rock_-1_0_2_lod1.usda@"));
  EXPECT_TRUE(has("custom double vug:distance = 0.125"));
  EXPECT_TRUE(has("(0, 0, 0), (1, 1, 1), (0.25, 0.25, 0.25), (0.5, 0.5, 0.5)]"));
  const std::string leaf = text.substr(text.find("def Xform \"leaf\""));
  EXPECT_NE(leaf.find("prepend payload = @./leaf_whole.usda@"), std::string::npos);
  EXPECT_EQ(leaf.find("variantSet"), std::string::npos);
}

}  // namespace
}  // namespace vug::exchange
