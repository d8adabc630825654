// SPDX-License-Identifier: Apache-2.0
// Parts of a level set that are meshed separately have the triangles of the whole, in the same
// order.
#include "solids.h"

#include <vug/base/rng.h>
#include <vug/field/displace.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace vug::meshing {
namespace {

using field::Field;
using volume::LatticeBox;

constexpr double kTileVoxel = 0.08;

/// Positions and normals of the corners.
using Corners = std::array<std::array<float, 6>, 3>;

std::vector<Corners> triangles_in(const mesh::Mesh& mesh, const Box3d& box) {
  std::vector<Corners> out;
  for (const mesh::Triangle& triangle : mesh.triangles) {
    Corners corners;
    Vec3d sum(0);
    for (size_t k = 0; k < 3; ++k) {
      const Vec3f &p = mesh.positions[triangle[k]], &n = mesh.normals[triangle[k]];
      corners[k] = {p.x, p.y, p.z, n.x, n.y, n.z};
      sum += Vec3d(p);
    }
    const Vec3d centre = sum / 3.0;
    bool within = true;  // Half-open, so that each triangle is in one tile.
    for (int axis = 0; axis < 3; ++axis)
      within = within && centre[axis] >= box.min[axis] && centre[axis] < box.max[axis];
    if (within) out.push_back(corners);
  }
  return out;
}

/// Creases, blends, a rough surface, thin parts, and surfaces that almost touch.
std::vector<std::pair<std::string, Field>> tiled_solids() {
  const auto ball = [](const Vec3d& at, double radius) {
    return field::transformed(field::make("sphere", {{"radius", radius}}),
                              Transform::translation(at));
  };
  std::vector<Field> crowd;
  RandomStream random(RandomKey(12));
  for (int i = 0; i < 60; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    crowd.push_back(ball({x, y, z}, random.uniform(0.1, 0.5)));
  }
  const Field box = field::transformed(field::make("box", {{"size", Vec3d(2.3, 1.7, 2.1)}}),
                                       Transform::rotation({1, 2, 3}, 0.6));
  return {
      {"crowd", field::unite(crowd)},
      {"blended", field::unite(crowd, {field::Profile::smooth, 0.1})},
      {"box with holes", field::subtract(box, crowd)},
      {"rough", field::displaced(ball({0.1, 0.2, 0.3}, 1.2), field::make_noise("worley"),
                                 field::Displacement())},
  };
}

TEST(MeshTiles, HaveTheTrianglesOfTheWhole) {
  volume::VoxelizeOptions options;
  options.voxel = kTileVoxel;
  for (const auto& [name, solid] : tiled_solids()) {
    const volume::LevelSet whole = volume::voxelize(solid, options);
    const mesh::Mesh expected = polygonize(whole, &solid).mesh;
    const volume::Statistics s = whole.statistics();
    for (const auto& [edge, offset] : {std::pair(32, 0), {24, 8}}) {
      size_t found = 0, tiles = 0;
      const auto first = [&](int axis) {
        return static_cast<int>(std::floor((s.index_min[axis] - 1 - offset) / double(edge))) *
                   edge +
               offset;
      };
      for (int x = first(0); x <= s.index_max.x; x += edge)
        for (int y = first(1); y <= s.index_max.y; y += edge)
          for (int z = first(2); z <= s.index_max.z; z += edge) {
            constexpr int kApron = 24;
            volume::VoxelizeOptions part = options;
            part.tile = LatticeBox(Vec3i(x, y, z) - Vec3i(kApron),
                                   Vec3i(x, y, z) + Vec3i(edge + kApron - 1));
            const mesh::Mesh mesh = polygonize(volume::voxelize(solid, part), &solid).mesh;
            const Box3d box(Vec3d(x, y, z) * kTileVoxel,
                            Vec3d(x + edge, y + edge, z + edge) * kTileVoxel);
            const auto own = triangles_in(mesh, box), same = triangles_in(expected, box);
            EXPECT_EQ(own == same, true)
                << name << ": tile of " << edge << " at " << x << " " << y << " " << z << " has "
                << own.size() << " triangles, not " << same.size();
            found += own.size();
            ++tiles;
          }
      EXPECT_GE(tiles, 8u);
      EXPECT_EQ(found, expected.triangles.size()) << name;
    }
  }
}

TEST(MeshTiles, OrderVerticesByTheCellsOfTheLattice) {
  for (const auto& [name, solid] : tiled_solids()) {
    volume::VoxelizeOptions options;
    options.voxel = kTileVoxel;
    const mesh::Mesh mesh = polygonize(volume::voxelize(solid, options), nullptr).mesh;
    const auto cell = [&](const Vec3f& p) {
      std::array<int64_t, 3> out{};
      for (int axis = 0; axis < 3; ++axis)
        out[static_cast<size_t>(axis)] =
            static_cast<int64_t>(std::floor(static_cast<double>(p[axis]) / kTileVoxel));
      return out;
    };
    EXPECT_TRUE(std::is_sorted(mesh.positions.begin(), mesh.positions.end(),
                               [&](const Vec3f& a, const Vec3f& b) { return cell(a) < cell(b); }))
        << name;
  }
}

}  // namespace
}  // namespace vug::meshing
