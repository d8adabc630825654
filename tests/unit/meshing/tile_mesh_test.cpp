// SPDX-License-Identifier: Apache-2.0
// The tiles of a surface, meshed separately, are joined to the mesh of the whole, byte for byte,
// and have its connected components.
#include "solids.h"

#include <vug/base/rng.h>
#include <vug/field/displace.h>
#include <vug/mesh/components.h>
#include <vug/mesh/topology.h>
#include <vug/meshing/tile_pieces.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::meshing {
namespace {

using field::Field;
using volume::LatticeBox;

constexpr double kVoxelOfTiles = 0.08;

Field sphere_in_space(const Vec3d& at, double radius) {
  return field::transformed(field::make("sphere", {{"radius", radius}}),
                            Transform::translation(at));
}

/// A rough body, many small bodies near it, and a bar that crosses several tiles.
Field scattered_solid() {
  std::vector<Field> parts = {field::displaced(sphere_in_space({0.1, 0.2, 0.3}, 1.1),
                                               field::make_noise("worley"), field::Displacement()),
                              field::transformed(field::make("box", {{"size", Vec3d(5, 0.3, 0.4)}}),
                                                 Transform::translation({0.3, 2.2, 0.1}))};
  RandomStream random(RandomKey(3));
  for (int i = 0; i < 60; ++i) {
    const double x = random.uniform(-2.5, 2.5), y = random.uniform(-2.5, 2.5),
                 z = random.uniform(-2.5, 2.5);
    parts.push_back(sphere_in_space({x, y, z}, random.uniform(0.1, 0.35)));
  }
  return field::unite(std::move(parts));
}

volume::VoxelizeOptions options_of_tiles() {
  volume::VoxelizeOptions options;
  options.voxel = kVoxelOfTiles;
  return options;
}

struct Tiled {
  std::vector<TileMesh> tiles;
  std::vector<LatticeBox> boxes;
};

Tiled tiled(const Field& solid, int edge) {
  PolygonizeOptions how;
  how.keys = true;
  Tiled out;
  const double size = edge * kVoxelOfTiles;
  Vec3i low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<int>(std::floor((solid.bounds().min[axis] - 0.5) / size));
    high[axis] = static_cast<int>(std::floor((solid.bounds().max[axis] + 0.5) / size));
  }
  for (int x = low.x; x <= high.x; ++x)
    for (int y = low.y; y <= high.y; ++y)
      for (int z = low.z; z <= high.z; ++z) {
        const Vec3i first = Vec3i(x, y, z) * edge;
        const LatticeBox box(first, first + Vec3i(edge - 1));
        volume::VoxelizeOptions part = options_of_tiles();
        part.tile = LatticeBox(box.min - Vec3i(kMeshApron), box.max + Vec3i(kMeshApron));
        const PolygonizeResult made = polygonize(volume::voxelize(solid, part), &solid, how);
        out.tiles.push_back(tile_mesh(made.mesh, *made.keys, box));
        out.boxes.push_back(box);
      }
  return out;
}

TEST(TileMeshes, JoinToTheMeshOfTheWhole) {
  const Field solid = scattered_solid();
  const mesh::Mesh whole = polygonize(volume::voxelize(solid, options_of_tiles()), &solid).mesh;
  for (const int edge : {24, 64}) {
    Tiled parts = tiled(solid, edge);
    ASSERT_GE(parts.tiles.size(), 8u);
    EXPECT_EQ(joined(parts.tiles) == whole, true) << edge;
    std::reverse(parts.tiles.begin(), parts.tiles.end());
    EXPECT_EQ(joined(parts.tiles) == whole, true) << edge << ", reversed";
  }
}

TEST(TileMeshes, HaveTheirBorderEdgesTwice) {
  const Field solid = scattered_solid();
  const mesh::Topology found = mesh::inspect(joined(tiled(solid, 24).tiles));
  EXPECT_TRUE(found.closed());
  EXPECT_EQ(found.misoriented_edges, 0u);
}

std::vector<uint32_t> components_of(const mesh::Mesh& mesh) {
  return mesh::face_components(mesh, mesh::find_edges(mesh));
}

TEST(TileMeshes, LoseThePiecesThatTheWholeLoses) {
  const Field solid = scattered_solid();
  const mesh::Mesh whole = polygonize(volume::voxelize(solid, options_of_tiles()), &solid).mesh;
  const size_t pieces = mesh::inspect(whole).components;
  ASSERT_GT(pieces, 10u);
  const Tiled parts = tiled(solid, 24);
  TilePieces all;
  for (size_t i = 0; i < parts.tiles.size(); ++i) all.add(parts.tiles[i], parts.boxes[i]);
  for (const double smallest : {0.0, 0.5, 1.0, 4.0, 100.0}) {
    const mesh::LargeComponents expected = mesh::large_components(whole, smallest);
    const TilePieces::Large large = all.large(smallest);
    EXPECT_EQ(large.removed, expected.removed) << smallest;
    size_t triangles = 0;
    for (size_t i = 0; i < parts.tiles.size(); ++i)
      triangles +=
          mesh::remaining(parts.tiles[i].mesh, components_of(parts.tiles[i].mesh), large.remains[i])
              .triangles.size();
    EXPECT_EQ(triangles, expected.mesh.triangles.size()) << smallest;
  }
  EXPECT_GT(all.large(0.5).removed, 0u);
  EXPECT_EQ(all.large(100).removed, pieces - 1);
}

// Two rooms of a closed box, connected by nothing: no way leads through the wall at the corner
// where eight tiles meet.
TEST(TileMeshes, AreTightWhereEightTilesMeet) {
  const Field box = field::make("box", {{"size", Vec3d(3.0)}});
  const Field room = field::subtract(box, {field::make("box", {{"size", Vec3d(2.6)}})});
  const Tiled parts = tiled(room, 64);
  ASSERT_EQ(parts.tiles.size(), 8u);
  const mesh::Mesh whole = joined(parts.tiles);
  const mesh::Topology found = mesh::inspect(whole);
  EXPECT_TRUE(found.closed());
  EXPECT_EQ(found.components, 2u);
  // Rays from the middle meet the walls of the tile they run in an odd number of times.
  RandomStream random(RandomKey(9));
  for (int i = 0; i < 2000; ++i) {
    Vec3d way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (way.length() < 0.1) continue;
    way.normalize();
    int inner = 0, outer = 0;
    for (size_t face = 0; face < whole.triangles.size(); ++face) {
      const auto [a, b, c] = mesh::corners(whole, face);
      const double volume_ab = way.dot(a.cross(b)), volume_bc = way.dot(b.cross(c)),
                   volume_ca = way.dot(c.cross(a));
      const bool front = volume_ab > 0 && volume_bc > 0 && volume_ca > 0,
                 back = volume_ab < 0 && volume_bc < 0 && volume_ca < 0;
      if ((front || back) && way.dot(a + b + c) > 0) ++(front ? outer : inner);
    }
    EXPECT_EQ(outer, 1) << way.x << " " << way.y << " " << way.z;
    EXPECT_EQ(inner, 1) << way.x << " " << way.y << " " << way.z;
  }
}

TEST(TileMeshes, StoreTheirKeysRelativeToTheTile) {
  const Field solid = sphere_in_space({0.1, 0.2, 0.3}, 1.1);
  Tiled parts = tiled(solid, 64);
  for (size_t i = 0; i < parts.tiles.size(); ++i) {
    add_key_attribute(parts.tiles[i], parts.boxes[i]);
    const mesh::Attribute* keys = mesh::find_attribute(parts.tiles[i].mesh, kLatticeKey, 4);
    ASSERT_TRUE(keys);
    ASSERT_EQ(keys->values.size(), 4 * parts.tiles[i].mesh.positions.size());
    for (size_t v = 0; v < parts.tiles[i].mesh.positions.size(); ++v)
      for (size_t axis = 0; axis < 3; ++axis) {
        const float cell = keys->values[4 * v + axis];
        EXPECT_GE(cell, -1) << v;
        EXPECT_LE(cell, 64) << v;
      }
  }
}

}  // namespace
}  // namespace vug::meshing
