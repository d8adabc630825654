// SPDX-License-Identifier: Apache-2.0
// Levels of detail of eight tiles of a curved cave: any mix of levels is closed, and dense samples
// never exceed the stated distances.
#include "solids.h"

#include <vug/base/rng.h>
#include <vug/field/displace.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/topology.h>
#include <vug/mesh/weld.h>
#include <vug/meshing/tile_levels.h>
#include <vug/meshing/tile_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace vug::meshing {
namespace {

using volume::LatticeBox;

constexpr double kVoxelOfLevels = 0.05;
constexpr int kEdgeOfLevels = 64;

/// A rock with a curved, rough cave that crosses all eight tiles about the origin.
field::Field curved_cave() {
  const field::Field rock = field::make("sphere", {{"radius", 2.9}});
  const field::Field ring = turned(solid(Ring{1.6, 0.6}), {1, 0.4, 0.2}, 0.7, {0.1, 0.05, -0.1});
  const field::Field bend = turned(solid(Ring{1.2, 0.4}), {0.3, 0.2, 1}, 1.4, {0.3, 0.5, 0.2});
  field::Displacement rough;
  rough.amount = 0.15;
  return field::subtract(
      rock, {field::displaced(field::unite({ring, bend}), field::make_noise("worley"), rough)});
}

/// The full mesh of each tile, and its levels; a mix has one of them for each tile.
struct Levels {
  std::vector<TileMesh> tiles;
  std::vector<std::vector<TileLevel>> coarser;

  const mesh::Mesh& at(size_t tile, size_t level) const {
    const auto& own = coarser[tile];
    level = std::min(level, own.size());
    return level == 0 ? tiles[tile].mesh : own[level - 1].mesh;
  }
};

const Levels& cave_levels() {
  static const Levels all = [] {
    const field::Field cave = curved_cave();
    Levels out;
    for (int i = 0; i < 8; ++i) {
      const Vec3i first = Vec3i(i / 4 - 1, i / 2 % 2 - 1, i % 2 - 1) * kEdgeOfLevels;
      const LatticeBox box(first, first + Vec3i(kEdgeOfLevels - 1));
      volume::VoxelizeOptions part;
      part.voxel = kVoxelOfLevels;
      part.tile = LatticeBox(box.min - Vec3i(kMeshApron), box.max + Vec3i(kMeshApron));
      PolygonizeOptions how;
      how.keys = true;
      const PolygonizeResult made = polygonize(volume::voxelize(cave, part), &cave, how);
      out.tiles.push_back(tile_mesh(made.mesh, *made.keys, box));
      add_key_attribute(out.tiles.back(), box);
      out.coarser.push_back(tile_levels(out.tiles.back().mesh, 3));
    }
    return out;
  }();
  return all;
}

/// The tiles at these levels in one mesh, joined by equal positions.
mesh::Mesh welded_mix(const std::array<size_t, 8>& levels) {
  mesh::Mesh all;
  for (size_t tile = 0; tile < 8; ++tile) {
    const mesh::Mesh& part = cave_levels().at(tile, levels[tile]);
    const auto first = static_cast<uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
    for (const mesh::Triangle& t : part.triangles)
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return mesh::welded(all);
}

void expect_closed_mix(const std::array<size_t, 8>& levels) {
  const mesh::Mesh mix = welded_mix(levels);
  const mesh::Edges edges = mesh::find_edges(mix);
  size_t open = 0, nonmanifold = 0;
  for (const mesh::Edge& edge : edges.edges) {
    open += edge.count == 1 ? 1 : 0;
    nonmanifold += edge.count > 2 ? 1 : 0;
  }
  const std::string name = testing::PrintToString(levels);
  EXPECT_EQ(open, 0u) << name;
  EXPECT_EQ(nonmanifold, 0u) << name;
  size_t triangles = 0;  // Welding removes none, so that equal positions are equal vertices.
  for (size_t tile = 0; tile < 8; ++tile)
    triangles += cave_levels().at(tile, levels[tile]).triangles.size();
  EXPECT_EQ(mix.triangles.size(), triangles) << name;
}

TEST(TileLevels, HaveFewerAndFewerTriangles) {
  size_t with_two = 0;
  for (size_t tile = 0; tile < 8; ++tile) {
    size_t before = cave_levels().at(tile, 0).triangles.size();
    ASSERT_GT(before, 1000u);
    double last = 0;
    ASSERT_GE(cave_levels().coarser[tile].size(), 1u);
    with_two += cave_levels().coarser[tile].size() >= 2 ? 1 : 0;
    for (const TileLevel& level : cave_levels().coarser[tile]) {
      EXPECT_LE(4 * level.mesh.triangles.size(), 3 * before);
      EXPECT_GT(level.distance, last);
      EXPECT_LT(level.distance, 6 * kVoxelOfLevels);
      EXPECT_NO_THROW(mesh::validate(level.mesh, "t"));
      before = level.mesh.triangles.size();
      last = level.distance;
    }
  }
  EXPECT_GE(with_two, 6u);
}

using LevelPoint = std::array<float, 3>;
using LevelEdge = std::pair<LevelPoint, LevelPoint>;

/// How often each edge has one of its two directions, by the bits of the positions.
std::map<LevelEdge, int> uses_of_edges(const mesh::Mesh& mesh) {
  const auto point = [&](uint32_t v) {
    return LevelPoint{mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z};
  };
  std::map<LevelEdge, int> out;
  for (const mesh::Triangle& t : mesh.triangles)
    for (size_t k = 0; k < 3; ++k) ++out[{point(t[k]), point(t[(k + 1) % 3])}];
  return out;
}

// The proof for all mixes: all levels of a tile have the same directed border edges; all other
// edges are used once in each direction by their own tile, and by no level of another tile.
TEST(TileLevels, AllMixesAreClosed) {
  std::array<std::set<LevelEdge>, 8> borders, inner;
  for (size_t tile = 0; tile < 8; ++tile)
    for (size_t level = 0; level <= cave_levels().coarser[tile].size(); ++level) {
      const std::map<LevelEdge, int> uses = uses_of_edges(cave_levels().at(tile, level));
      std::set<LevelEdge> border;
      for (const auto& [edge, count] : uses) {
        ASSERT_EQ(count, 1);
        if (uses.count({edge.second, edge.first}) == 0)
          border.insert(edge);
        else
          inner[tile].insert(edge);
      }
      if (level == 0) borders[tile] = border;
      EXPECT_TRUE(border == borders[tile]) << tile << " " << level;
    }
  std::map<LevelEdge, int> border_uses;
  for (const std::set<LevelEdge>& border : borders)
    for (const LevelEdge& edge : border) ++border_uses[edge];
  ASSERT_GT(border_uses.size(), 500u);
  for (const auto& [edge, count] : border_uses) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(border_uses.count({edge.second, edge.first}), 1u);
  }
  for (size_t tile = 0; tile < 8; ++tile)
    for (const LevelEdge& edge : inner[tile]) {
      EXPECT_EQ(border_uses.count(edge), 0u);
      for (size_t other = 0; other < tile; ++other) EXPECT_EQ(inner[other].count(edge), 0u);
    }
}

TEST(TileLevels, MixesOfTwoLevelsAreClosedWhenWelded) {
  for (unsigned mix = 0; mix < 256; ++mix) {
    std::array<size_t, 8> levels{};
    for (unsigned tile = 0; tile < 8; ++tile) levels[tile] = (mix >> tile & 1u) != 0 ? 3 : 0;
    expect_closed_mix(levels);
  }
}

TEST(TileLevels, RandomMixesAreClosedWhenWelded) {
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 200; ++i) {
    std::array<size_t, 8> levels{};
    for (size_t& level : levels)
      level = std::min<size_t>(3, static_cast<size_t>(random.uniform(0, 4)));
    expect_closed_mix(levels);
  }
}

/// The largest distance of random points of a mesh, `per_triangle` on each triangle, from another
/// surface. Unlike the bound, it depends on chance and uses the distance of mesh::MeshDistance.
double sampled_distance(const mesh::Mesh& from, const mesh::Mesh& to, int per_triangle,
                        RandomStream& random) {
  const mesh::MeshDistance distance(to);
  double most = 0;
  for (size_t face = 0; face < from.triangles.size(); ++face)
    for (int i = 0; i < per_triangle; ++i) {
      const auto [a, b, c] = mesh::corners(from, face);
      double u = random.uniform(0, 1), v = random.uniform(0, 1);
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      most = std::max(most, distance.closest(a + (b - a) * u + (c - a) * v).distance);
    }
  return most;
}

TEST(TileLevels, SamplesNeverExceedTheStatedDistance) {
  RandomStream random(RandomKey(77));
  for (size_t tile = 0; tile < 8; ++tile) {
    const mesh::Mesh& full = cave_levels().at(tile, 0);
    int per_triangle = 16;
    for (const TileLevel& level : cave_levels().coarser[tile]) {
      const double found = std::max(sampled_distance(full, level.mesh, 4, random),
                                    sampled_distance(level.mesh, full, per_triangle, random));
      EXPECT_LE(found, level.distance) << tile;
      EXPECT_GE(found, 0.7 * level.distance) << tile;
      per_triangle *= 4;
    }
  }
}

TEST(TileLevels, KeysStayThoseOfTheVertices) {
  const TileMesh& tile = cave_levels().tiles[3];
  std::map<LevelPoint, std::array<float, 4>> keys;
  const auto add = [](const mesh::Mesh& mesh, const auto& visit) {
    const mesh::Attribute* own = mesh::find_attribute(mesh, kLatticeKey, 4);
    ASSERT_TRUE(own);
    for (size_t v = 0; v < mesh.positions.size(); ++v)
      visit(LevelPoint{mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z},
            std::array<float, 4>{own->values[4 * v], own->values[4 * v + 1], own->values[4 * v + 2],
                                 own->values[4 * v + 3]});
  };
  add(tile.mesh, [&](const LevelPoint& p, const std::array<float, 4>& key) { keys[p] = key; });
  for (const TileLevel& level : cave_levels().coarser[3])
    add(level.mesh, [&](const LevelPoint& p, const std::array<float, 4>& key) {
      ASSERT_EQ(keys.count(p), 1u);
      EXPECT_EQ(keys.at(p), key);
    });
}

TEST(TileLevels, EndWhereTheBorderPreventsMore) {
  EXPECT_TRUE(tile_levels(mesh::Mesh(), 3).empty());
  // A triangle alone is all border.
  mesh::Mesh one;
  one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  EXPECT_TRUE(tile_levels(one, 3).empty());
  for (const size_t tile : {0u, 7u}) {
    const std::vector<TileLevel> many = tile_levels(cave_levels().at(tile, 0), 12);
    ASSERT_FALSE(many.empty());
    EXPECT_LT(many.size(), 5u);
    const std::map<LevelEdge, int> uses = uses_of_edges(many.back().mesh);
    size_t border = 0;
    for (const auto& [edge, count] : uses) border += 1 - uses.count({edge.second, edge.first});
    EXPECT_GE(many.back().mesh.triangles.size(), 2 * border);
  }
}

}  // namespace
}  // namespace vug::meshing
