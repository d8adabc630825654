// SPDX-License-Identifier: Apache-2.0
// Meshes have no triangles that intersect, fold or have no area: where samples are zero, where
// sheets of the surface are close, with and without the polish.
#include "solids.h"

#include <vug/field/noise.h>
#include <vug/mesh/folds.h>
#include <vug/mesh/self_intersections.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/topology.h>
#include <vug/volume/from_mesh.h>

#include <gtest/gtest.h>

namespace vug::meshing {
namespace {

void expect_valid(const mesh::Mesh& mesh) {
  const mesh::Topology topology = mesh::inspect(mesh);
  EXPECT_FALSE(mesh.triangles.empty());
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.degenerate_triangles, 0U);
  EXPECT_EQ(mesh::folded_triangles(mesh).size(), 0U);
  EXPECT_EQ(mesh::self_intersections(mesh).size(), 0U);
}

PolygonizeOptions unpolished() {
  PolygonizeOptions options;
  options.polish = false;
  return options;
}

field::Field box_at(const Vec3d& centre, const Vec3d& half) {
  return field::transformed(solid(Box{half}), Transform::translation(centre));
}

// The samples of its faces, edges and tips are zero, also those of single lattice points.
TEST(ValidMeshes, OfSolidsOnTheLattice) {
  const field::Field cone = solid(Cone{0.4, 0.8});
  const field::Field octahedron_like =
      field::intersect({cone, field::transformed(cone, Transform::rotation({1, 0, 0}, kPi))});
  // A wall with openings, sills and a cornice, whose faces are all on the lattice.
  const field::Field wall = box_at({0, 0, 0}, {1.5, 1, 0.1});
  const field::Field front = field::unite(
      {field::subtract(
           wall, {box_at({-0.7, 0.1, 0}, {0.3, 0.5, 0.2}), box_at({0.7, 0.1, 0}, {0.3, 0.5, 0.2})}),
       box_at({-0.7, -0.45, 0.15}, {0.4, 0.05, 0.05}),
       box_at({0.7, -0.45, 0.15}, {0.4, 0.05, 0.05}), box_at({0, 1.1, 0.05}, {1.6, 0.1, 0.2})});
  // Boxes that share only an edge, and only a corner.
  const field::Field edge =
      field::unite({box_at({-0.5, -0.5, 0}, Vec3d(0.5)), box_at({0.5, 0.5, 0}, Vec3d(0.5))});
  const field::Field corner =
      field::unite({box_at(Vec3d(-0.5), Vec3d(0.5)), box_at(Vec3d(0.5), Vec3d(0.5))});
  for (const field::Field& field : {cone, octahedron_like, front, edge, corner}) {
    expect_valid(polygonized(field, 0.05).mesh);
    expect_valid(polygonized(field, 0.05, unpolished()).mesh);
    expect_valid(polygonized(turned(field, {1, 2, 3}, 0.7), 0.05).mesh);
  }
}

TEST(ValidMeshes, OfLevelSetsOfMeshesThatTouch) {
  mesh::Mesh both = mesh::box_mesh(Box3d(Vec3d(-1, 0, 0), Vec3d(0, 1, 1)));
  const mesh::Mesh other = mesh::box_mesh(Box3d(Vec3d(0, 0, 0), Vec3d(1, 1, 1)));
  const auto first = static_cast<uint32_t>(both.positions.size());
  both.positions.insert(both.positions.end(), other.positions.begin(), other.positions.end());
  for (const mesh::Triangle& t : other.triangles)
    both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  volume::FromMeshOptions options;
  options.voxel = 0.05;
  const mesh::Mesh mesh = polygonize(volume::from_mesh(both, options), nullptr).mesh;
  expect_valid(mesh);
  EXPECT_EQ(mesh::inspect(mesh).components, 1U);
  EXPECT_NEAR(area(mesh) / 10, 1, 0.02);
}

// Rough rock with bubbles, crumbs and walls thinner than a voxel, of many seeds.
TEST(ValidMeshes, OfRoughRock) {
  const field::Field ball = field::make("sphere", {{"radius", 0.8}});
  for (int seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const field::Noise fbm =
        field::make_noise("fbm", {{"scale", 0.25}, {"octaves", 4}, {"seed", seed}});
    const field::Field rock = field::make(
        "displace",
        {{"field", field::as_value(ball)}, {"noise", field::as_value(fbm)}, {"amount", 0.2}});
    expect_valid(polygonized(rock, 0.06).mesh);
    expect_valid(polygonized(rock, 0.06, unpolished()).mesh);
  }
}

}  // namespace
}  // namespace vug::meshing
