// SPDX-License-Identifier: Apache-2.0
#include "made.h"

#include <vug/base/error.h>
#include <vug/cells/quality.h>
#include <vug/cells/surface_distance.h>
#include <vug/mesh/polygon.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

TEST(Build, EveryGridIsValidAndHasItsDensity) {
  const Surface box({shared(mesh::box_mesh({Vec3d(0), Vec3d(1, 2, 1.5)}))});
  const Surface ball({shared(mesh::sphere_mesh(Vec3d(0), 1, 4))});
  for (const GridKind* kind : grids())
    for (const Surface* surface : {&box, &ball}) {
      const BuildOptions o = options(kind->info.name, 0.04);
      const Network n = build(*surface, o).network;
      validate(n);
      // On curved facets, patches of the pattern meet at seams, which reduces the density, most for
      // sparse patterns.
      const double share = static_cast<double>(n.size()) / estimate(*surface, o.grid, o.spacing);
      EXPECT_NEAR(share, 1, surface == &box ? 0.03 : 0.2) << kind->info.name;
      double area = 0;
      for (const float a : n.area) area += static_cast<double>(a);
      EXPECT_NEAR(area / surface->area(), 1, 1e-4) << kind->info.name;
    }
}

TEST(Build, PatternsAreRegularInsideAPolygon) {
  const Surface floor({shared(floor_mesh())});
  struct Case {
    const char* grid;
    NamedValues parameters;
    uint32_t full;
    double longest;
  };
  for (const Case& c :
       {Case{"triangle", {}, 6, 1}, Case{"square", {}, 4, 1},
        Case{"square", {{"neighbors", 8}}, 8, std::sqrt(2.0)}, Case{"hexagon", {}, 3, 1}}) {
    const Network n = build(floor, options(c.grid, 0.02, c.parameters)).network;
    for (uint32_t i = 0; i < n.size(); ++i) {
      const Vec3f& p = n.position[i];
      if (std::min({p.x, p.z, 1 - p.x, 1 - p.z}) < 0.08f) continue;  // Darts at the border.
      ASSERT_EQ(n.links.degree(i), c.full) << c.grid;
      for (const uint32_t to : n.links.of(i)) {
        const float d = (n.position[to] - p).length();
        ASSERT_GT(d, 0.02f * 0.999f);
        ASSERT_LT(d, 0.02f * 1.001f * static_cast<float>(c.longest));
      }
    }
  }
}

TEST(Build, RandomCellsHaveFiveToSevenNeighbours) {
  for (const mesh::Mesh& mesh :
       {mesh::sphere_mesh(Vec3d(0), 1, 5), mesh::box_mesh({Vec3d(0), Vec3d(2)})}) {
    const Surface surface({shared(mesh)});
    BuildOptions o = options("random", 0.05);
    const BuildResult built = build(surface, o);
    EXPECT_EQ(built.relaxation.size(), 30u);
    EXPECT_LT(built.relaxation.back().variation, 0.6 * built.relaxation.front().variation);
    const Quality even = quality(built.network);
    EXPECT_GE(even.share(5, 7), 0.97);
    EXPECT_LT(even.variation, 0.06);
    o.relax = 0;
    const Quality strewn = quality(build(surface, o).network);
    EXPECT_LT(strewn.share(5, 7), 0.97);
    EXPECT_GT(strewn.variation, 1.5 * even.variation);
    o.relax = 30;
    o.force = Force::paper;
    EXPECT_GT(quality(build(surface, o).network).variation, 1.1 * even.variation);
  }
}

TEST(Build, ConcavePolygonsAndHolesHaveTheSameDensity) {
  // An L of 3 square metres with a hole of 1/4, as one polygon and as five rectangles.
  mesh::Mesh whole;
  for (const Vec2f& p :
       {Vec2f(0, 0), Vec2f(0, 2), Vec2f(1, 2), Vec2f(1, 1), Vec2f(2, 1), Vec2f(2, 0),
        Vec2f(1.25f, 0.25f), Vec2f(1.25f, 0.75f), Vec2f(1.75f, 0.75f), Vec2f(1.75f, 0.25f)})
    whole.positions.emplace_back(p.x, 0, p.y);
  mesh::add_rings(whole, {{0, 1, 2, 3, 4, 5}, {6, 7, 8, 9}});
  mesh::Mesh parts;
  const auto rectangle = [&](float x0, float z0, float x1, float z1) {
    const auto first = static_cast<uint32_t>(parts.positions.size());
    for (const Vec2f& p : {Vec2f(x0, z0), Vec2f(x0, z1), Vec2f(x1, z1), Vec2f(x1, z0)})
      parts.positions.emplace_back(p.x, 0, p.y);
    mesh::add_polygon(parts, {first, first + 1, first + 2, first + 3});
  };
  rectangle(0, 0, 1, 2);
  rectangle(1, 0, 1.25f, 1);
  rectangle(1.25f, 0, 1.75f, 0.25f);
  rectangle(1.25f, 0.75f, 1.75f, 1);
  rectangle(1.75f, 0, 2, 1);
  for (const char* grid : {"triangle", "square", "random"}) {
    const Network a = build(Surface({shared(whole)}), options(grid, 0.02)).network;
    const Network b = build(Surface({shared(parts)}), options(grid, 0.02)).network;
    const double cells = estimate(Surface({shared(whole)}), options(grid, 0.02).grid, 0.02);
    EXPECT_NEAR(static_cast<double>(a.size()) / cells, 1, 0.02) << grid;
    EXPECT_NEAR(static_cast<double>(a.size()) / static_cast<double>(b.size()), 1, 0.01) << grid;
    for (const Vec3f& p : a.position)
      ASSERT_FALSE(p.x > 1.251f && p.x < 1.749f && p.z > 0.251f && p.z < 0.749f);
  }
}

TEST(Build, CellsStayOnTheSurface) {
  const Surface ball({shared(mesh::sphere_mesh(Vec3d(0), 1, 5))});
  for (const Vec3f& p : build(ball, options("random", 0.08)).network.position)
    ASSERT_NEAR(p.length(), 1, 0.002);  // The sagitta of the facets.
  const Surface floor({shared(floor_mesh())});
  for (const Vec3f& p : build(floor, options("random", 0.05)).network.position) {
    ASSERT_EQ(p.y, 0);
    ASSERT_GE(std::min({p.x, p.z, 1 - p.x, 1 - p.z}), 0);
  }
}

TEST(Build, SidesOfAThinWallAreNotLinked) {
  const Surface plate({shared(mesh::box_mesh({Vec3d(0, 0, 0), Vec3d(2, 0.002, 2)}))});
  for (const char* grid : {"triangle", "random"}) {
    const Network n = build(plate, options(grid, 0.05)).network;
    const double two_sides =
        2 * estimate(Surface({shared(floor_mesh())}), options(grid, 0.05).grid, 0.05) * 4;
    EXPECT_NEAR(static_cast<double>(n.size()) / two_sides, 1, 0.05)
        << grid;  // And not too close to each other.
    for (uint32_t i = 0; i < n.size(); ++i)
      for (const uint32_t to : n.links.of(i)) ASSERT_GT(n.normal[i].dot(n.normal[to]), -0.5f);
  }
}

TEST(Build, TouchingObjectsAreOneNetwork) {
  const mesh::MeshPtr left = shared(mesh::box_mesh({Vec3d(-1, 0, 0), Vec3d(0, 1, 1)}));
  const auto pieces = [&](double gap) {
    const Surface both({left, shared(mesh::box_mesh({Vec3d(gap, 0, 0), Vec3d(1, 1, 1)}))});
    const Network n = build(both, options("triangle", 0.05)).network;
    bool crosses = false;
    for (uint32_t i = 0; i < n.size(); ++i)
      for (const uint32_t to : n.links.of(i)) crosses |= n.object[i] != n.object[to];
    const std::vector<uint32_t> piece = components(n.links);
    const uint32_t count = 1 + *std::max_element(piece.begin(), piece.end());
    EXPECT_EQ(crosses, count == 1);
    return count;
  };
  EXPECT_EQ(pieces(0), 1u);
  EXPECT_EQ(pieces(0.2), 2u);
  // A box standing on a floor.
  const Surface standing({shared(mesh::box_mesh({Vec3d(-2, -1, -2), Vec3d(2, 0, 2)})), left});
  const std::vector<uint32_t> piece =
      components(build(standing, options("random", 0.08)).network.links);
  EXPECT_EQ(*std::max_element(piece.begin(), piece.end()), 0u);
}

TEST(Build, AcrossAnEdgeTheDistanceIsOverBothSides) {
  // One cell on top and one on the side of a box, 2 and 3 cm from the edge and 1 cm along it.
  const Vec3f top(0.02f, 0, 0), side(0, -0.03f, 0.01f);
  EXPECT_NEAR(surface_distance2(top, {0, 1, 0}, side, {-1, 0, 0}), 0.0025 + 0.0001, 1e-7);
  // The same in a corner, seen from inside, and on two sides of a wall.
  EXPECT_NEAR(surface_distance2(top, {0, -1, 0}, side, {1, 0, 0}), 0.0025 + 0.0001, 1e-7);
  EXPECT_TRUE(std::isinf(surface_distance2({0, 0, 0}, {0, 1, 0}, {0, -0.001f, 0}, {0, -1, 0})));
}

}  // namespace
}  // namespace vug::cells
