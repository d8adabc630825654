// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/triangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

Vec3d random_point(RandomStream& random, double reach) {
  const double x = random.uniform(-reach, reach);
  const double y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}

double box_distance(const Vec3d& p, double half) {
  Vec3d q;
  for (int axis = 0; axis < 3; ++axis) q[axis] = std::fabs(p[axis]) - half;
  const Vec3d out(std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0));
  return out.length() + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

TEST(Triangle, NearestPointIsNoFartherThanAnySample) {
  RandomStream random{RandomKey(1)};
  for (int trial = 0; trial < 300; ++trial) {
    const std::array<Vec3d, 3> t = {random_point(random, 1), random_point(random, 1),
                                    random_point(random, 1)};
    const Vec3d p = random_point(random, 2);
    const double found = (nearest_on_triangle(p, t).point - p).length();
    double sampled = kInfinity;
    constexpr int kSteps = 60;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j) {
        const double u = static_cast<double>(i) / kSteps;
        const double v = static_cast<double>(j) / kSteps;
        sampled = std::min(sampled, (t[0] * (1 - u - v) + t[1] * u + t[2] * v - p).length());
      }
    EXPECT_LE(found, sampled + 1e-12);
    EXPECT_GE(found, sampled - 3.0 / kSteps);  // No sample is further than one step from it.
  }
}

// At points straight above edges and corners, face normals alone would give wrong signs.
TEST(MeshDistance, OfABoxIsExactEverywhere) {
  const MeshDistance distance(box_mesh({Vec3d(-0.5), Vec3d(0.5)}));
  RandomStream random{RandomKey(2)};
  for (int i = 0; i < 5000; ++i) {
    const Vec3d p = random_point(random, 1.5);
    EXPECT_NEAR(distance.signed_distance(p), box_distance(p, 0.5), 1e-12);
  }
  for (int i = 0; i < 125; ++i) {
    const Vec3d p(0.5 * (i % 5) - 1, 0.5 * (i / 5 % 5) - 1, 0.5 * (i / 25) - 1);
    EXPECT_NEAR(distance.signed_distance(p), box_distance(p, 0.5), 1e-12);
  }
}

TEST(MeshDistance, SignIsRightAtSharpSpikes) {
  // A needle: at its tip the face normals differ by almost 180 degrees.
  Mesh needle;
  needle.positions = {{0, 10, 0}, {-0.1F, 0, -0.1F}, {0.1F, 0, -0.1F}, {0, 0, 0.15F}};
  needle.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
  const MeshDistance distance(needle);
  RandomStream random{RandomKey(3)};
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = Vec3d(0, 10.5, 0) + random_point(random, 0.45);
    EXPECT_GT(distance.signed_distance(p), 0);
  }
  EXPECT_LT(distance.signed_distance({0, 1, 0}), 0);
}

TEST(MeshDistance, AgreesWithBruteForce) {
  const Mesh mesh = torus_mesh(2, 0.7, 40, 20);
  const MeshDistance distance(mesh);
  RandomStream random{RandomKey(4)};
  for (int i = 0; i < 300; ++i) {
    const Vec3d p = random_point(random, 4);
    double best = kInfinity;
    for (size_t face = 0; face < mesh.triangles.size(); ++face)
      best = std::min(best, (nearest_on_triangle(p, corners(mesh, face)).point - p).length());
    EXPECT_DOUBLE_EQ(distance.closest(p).distance, best);
  }
}

TEST(MeshDistance, SeamsOfEqualPositionsDoNotMatter) {
  const Mesh whole = box_mesh({Vec3d(-0.5), Vec3d(0.5)});
  Mesh soup;
  for (const Triangle& t : whole.triangles) {
    const auto n = static_cast<uint32_t>(soup.positions.size());
    for (const uint32_t corner : t) soup.positions.push_back(whole.positions[corner]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  const MeshDistance distance(soup);
  RandomStream random{RandomKey(5)};
  for (int i = 0; i < 500; ++i) {
    const Vec3d p = random_point(random, 1.5);
    EXPECT_NEAR(distance.signed_distance(p), box_distance(p, 0.5), 1e-12);
  }
}

TEST(MeshDistance, RefusesAMeshWithoutArea) {
  Mesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_THROW(MeshDistance{line}, Error);
  EXPECT_THROW(MeshDistance{Mesh{}}, Error);
}

}  // namespace
}  // namespace vug::mesh
