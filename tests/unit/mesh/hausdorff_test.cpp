// SPDX-License-Identifier: Apache-2.0
// Bounds of the Hausdorff distance: known surfaces, and dense samples that never exceed them.
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/mesh/hausdorff.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/simplify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

/// The distance from a segment.
double from_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).length2(), 0.0, 1.0);
  return (p - (a + (b - a) * t)).length();
}

/// The distance from a triangle by another method than that of the library: from its plane, if the
/// foot is inside, otherwise from its edges.
double from_triangle(const Vec3d& p, const std::array<Vec3d, 3>& t) {
  const Vec3d n = (t[1] - t[0]).cross(t[2] - t[0]);
  bool inside = n.length2() > 0;
  double out = kInfinity;
  for (size_t k = 0; k < 3; ++k) {
    const Vec3d &a = t[k], &b = t[(k + 1) % 3];
    inside = inside && n.dot((b - a).cross(p - a)) >= 0;
    out = std::min(out, from_segment(p, a, b));
  }
  return inside ? std::min(out, std::fabs((p - t[0]).dot(n)) / n.length()) : out;
}

/// The largest distance of random points of one mesh from all triangles of the other.
double sampled(const Mesh& from, const Mesh& to, size_t count, uint64_t seed) {
  RandomStream random((RandomKey(seed)));
  double out = 0;
  for (size_t i = 0; i < count; ++i) {
    const auto [a, b, c] = corners(from, i % from.triangles.size());
    double u = random.uniform(0, 1), v = random.uniform(0, 1);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Vec3d p = a + (b - a) * u + (c - a) * v;
    double least = kInfinity;
    for (size_t face = 0; face < to.triangles.size(); ++face)
      least = std::min(least, from_triangle(p, corners(to, face)));
    out = std::max(out, least);
  }
  return out;
}

Mesh simplified(const Mesh& mesh, size_t triangles) {
  Simplifier simplifier(mesh);
  simplifier.reduce_to(triangles);
  return simplifier.mesh();
}

TEST(Hausdorff, KnownSurfaces) {
  const Mesh small = box_mesh(Box3d(Vec3d(0.0), Vec3d(1.0)));
  const Mesh moved = box_mesh(Box3d(Vec3d(0.25, 0, 0), Vec3d(1.25, 1, 1)));
  const Mesh large = box_mesh(Box3d(Vec3d(-1.0), Vec3d(2.0)));
  const auto expect = [](double bound, double exact) {
    EXPECT_GE(bound, exact * (1 - 1e-12));
    EXPECT_LE(bound, exact * 1.02);
  };
  expect(hausdorff_bound(small, moved), 0.25);
  expect(hausdorff_bound(moved, small), 0.25);
  // From a corner of the large cube to that of the small one, in either order.
  expect(hausdorff_bound(small, large), std::sqrt(3.0));
  expect(hausdorff_bound(large, small), std::sqrt(3.0));
  EXPECT_LT(hausdorff_bound(small, small), 0.02);  // Of edges of a metre.
  EXPECT_EQ(hausdorff_bound(small, Mesh()), 0);
}

// The farthest point is far from all vertices, edges and centres of triangles.
TEST(Hausdorff, TheFarthestPointIsInsideOfATriangle) {
  Mesh plane;
  plane.positions = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
  plane.triangles = {{0, 1, 2}};
  // The plane with a hole around (1, 1.7), whose radius the distance is.
  Mesh ring = plane;
  constexpr double kRadius = 0.37;
  constexpr uint32_t kSides = 720;
  for (uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2 * kPi * i / kSides;
    ring.positions.emplace_back(static_cast<float>(1 + kRadius * std::cos(angle)),
                                static_cast<float>(1.7 + kRadius * std::sin(angle)), 0.0f);
  }
  ring.triangles.clear();
  // The corner that each side of the hole faces.
  const auto corner = [](uint32_t side) {
    const double angle = 2 * kPi * (side + 0.5) / kSides;
    const Vec3d out(std::cos(angle), std::sin(angle), 0);
    uint32_t best = 0;
    double most = -1;
    for (uint32_t k = 0; k < 3; ++k) {
      const Vec3d to = Vec3d(k == 1 ? 9 : 0, k == 2 ? 9 : 0, 0) - Vec3d(1, 1.7, 0) - out * kRadius;
      if (to.normalized().dot(out) > most) best = k;
      most = std::max(most, to.normalized().dot(out));
    }
    return best;
  };
  for (uint32_t i = 0; i < kSides; ++i) {
    const uint32_t j = (i + 1) % kSides, own = corner(i), next = corner(j);
    ring.triangles.push_back({3 + i, own, 3 + j});
    if (own != next) ring.triangles.push_back({3 + j, own, next});
  }
  const double bound = hausdorff_bound(plane, ring);
  EXPECT_GE(bound, kRadius * std::cos(kPi / kSides) - 1e-6);
  EXPECT_LE(bound, kRadius * 1.02);
}

TEST(Hausdorff, SamplesNeverExceedTheBound) {
  uint64_t seed = 17;
  for (const Mesh& mesh : {sphere_mesh({1, 2, 3}, 1, 4), torus_mesh(1, 0.3, 60, 30)})
    for (const size_t divisor : {3u, 10u, 40u}) {
      const Mesh coarse = simplified(mesh, mesh.triangles.size() / divisor);
      const double bound = hausdorff_bound(mesh, coarse);
      const double found =
          std::max(sampled(mesh, coarse, 6000, seed), sampled(coarse, mesh, 2000, seed + 1));
      seed += 2;
      EXPECT_LE(found, bound);
      EXPECT_GE(found, 0.8 * bound);
      EXPECT_EQ(hausdorff_bound(coarse, mesh), bound);
    }
}

TEST(Hausdorff, IsTheSameForAnyNumberOfThreads) {
  const Mesh mesh = torus_mesh(1, 0.3, 120, 60), coarse = simplified(mesh, 2000);
  const double one = with_threads(1, [&] { return hausdorff_bound(mesh, coarse); });
  for (const int threads : {2, 7})
    EXPECT_EQ(with_threads(threads, [&] { return hausdorff_bound(mesh, coarse); }), one);
}

}  // namespace
}  // namespace vug::mesh
