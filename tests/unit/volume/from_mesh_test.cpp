// SPDX-License-Identifier: Apache-2.0
// A level set of a mesh has its distances, bounds the unreachable region, and rejects open meshes.
#include "solids.h"

#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/base/parallel.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/shapes.h>
#include <vug/volume/from_mesh.h>

#include <gtest/gtest.h>

namespace vug::volume {
namespace {

FromMeshOptions options(double voxel, double half_width = 3) {
  FromMeshOptions o;
  o.voxel = voxel;
  o.half_width = half_width;
  return o;
}

TEST(FromMesh, ValuesAreDistancesToTheMesh) {
  const mesh::Mesh ring = mesh::torus_mesh(1, 0.4, 96, 48);
  const mesh::MeshDistance exact(ring);
  for (const double half_width : {3.0, 4.5}) {
    const LevelSet grid = from_mesh(ring, options(0.05, half_width));
    EXPECT_EQ(check(grid).fault, "");
    EXPECT_TRUE(grid.holds_solid());
    EXPECT_NEAR(grid.background(), 0.05 * half_width, 1e-6);
    double worst = 0;
    each_lattice_point(grid, [&](const Vec3d& p, double value) {
      const auto closest = exact.closest(p);
      const bool inside = (p - closest.point).dot(closest.normal) < 0;
      const double wanted = std::min(closest.distance, grid.background()) * (inside ? -1 : 1);
      worst = std::max(worst, std::fabs(value - wanted));
    });
    EXPECT_LT(worst, 1e-5 * grid.voxel()) << "single precision of points 1.4 m away";
  }
}

TEST(FromMesh, IntersectingSurfacesBoundOneSolid) {
  const mesh::Mesh two = mesh::joined(mesh::sphere_mesh(Vec3d(-0.3, 0, 0), 0.5, 4),
                                      mesh::sphere_mesh(Vec3d(0.3, 0, 0), 0.5, 4));
  const LevelSet grid = from_mesh(two, options(0.04));
  EXPECT_EQ(check(grid).fault, "");
  for (const double x : {-0.7, -0.2, 0.0, 0.2, 0.7}) EXPECT_LT(grid.value(Vec3d(x, 0, 0)), 0) << x;
  EXPECT_GT(grid.value(Vec3d(0, 0.5, 0)), 0);
}

mesh::Mesh turned(mesh::Mesh mesh) {
  for (mesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

// A room in rock with a boulder that floats in it and has a bubble, and a stone next to the rock.
TEST(FromMesh, SurfacesWithNormalsIntoTheirInteriorBoundCavities) {
  const auto ball = [](double x, double radius) {
    return mesh::sphere_mesh(Vec3d(x, 0, 0), radius, 3);
  };
  const mesh::Mesh cave =
      mesh::joined(mesh::joined(mesh::joined(ball(0, 1), turned(ball(0, 0.7))),
                                mesh::joined(ball(0.2, 0.3), turned(ball(0.2, 0.15)))),
                   turned(ball(1.5, 0.3)));
  for (const mesh::Mesh& each : {cave, turned(cave)}) {
    const LevelSet grid = from_mesh(each, options(0.03));
    EXPECT_EQ(check(grid).fault, "");
    for (const double x : {-0.85, 0.85, 0.4, 0.0}) EXPECT_LT(grid.value(Vec3d(x, 0, 0)), 0) << x;
    for (const double x : {-1.2, -0.5, 0.6, 0.2}) EXPECT_GT(grid.value(Vec3d(x, 0, 0)), 0) << x;
  }
  EXPECT_LT(from_mesh(cave, options(0.03)).value(Vec3d(1.5, 0, 0)), 0)
      << "outside of the rock nothing is hollow";
  const LevelSet grid = from_mesh(cave, options(0.03));
  const mesh::MeshDistance exact(cave);
  each_lattice_point(grid, [&](const Vec3d& p, double value) {
    ASSERT_NEAR(std::fabs(value), std::min(exact.closest(p).distance, grid.background()), 1e-6)
        << p;
  });
}

TEST(FromMesh, SameBytesForAnyNumberOfThreads) {
  const mesh::Mesh ring = mesh::torus_mesh(1, 0.4, 64, 32);
  std::vector<Digest> made;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] { made.push_back(from_mesh(ring, options(0.04)).content()); });
  }
  EXPECT_EQ(made[0], made[1]);
  EXPECT_EQ(made[0], made[2]);
}

TEST(FromMesh, RefusesOpenMeshesAndHugeSizes) {
  mesh::Mesh open = mesh::sphere_mesh(Vec3d(0), 1, 2);
  open.triangles.pop_back();
  try {
    from_mesh(open, options(0.1));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    EXPECT_EQ(std::string(error.what()), "a mesh with 3 open edges does not bound a solid");
  }
  FromMeshOptions small = options(1e-4);
  small.max_memory = 1 << 20;
  const mesh::Mesh ball = mesh::sphere_mesh(Vec3d(0), 1, 2);
  EXPECT_THROW(from_mesh(ball, small), Error);
  EXPECT_THROW(from_mesh(mesh::sphere_mesh(Vec3d(1e6, 0, 0), 1, 2), options(1e-4)), Error);
  Progress stopped;
  stopped.cancel();
  EXPECT_THROW(from_mesh(ball, options(0.1), stopped), Error);
  EXPECT_TRUE(from_mesh(mesh::Mesh(), options(0.1)).empty());
}

}  // namespace
}  // namespace vug::volume
