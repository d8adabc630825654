// SPDX-License-Identifier: Apache-2.0
// Edges of a box with a box removed: the distance of its true edges from the mesh, with and without
// polish.
#include "solids.h"

#include <vug/base/rng.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/self_intersections.h>
#include <vug/meshing/crease.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::meshing {
namespace {

/// Points on the edges of one box (rotated by `place`) that lie on the solid's surface and are at
/// least 3 voxels from the other box: the level set does not resolve thinner regions.
std::vector<Vec3d> edge_points(const Transform& place, double half, const field::Field& solid,
                               const field::Field& other, double voxel) {
  std::vector<Vec3d> points;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 4; ++side)
      for (int i = 0; i <= 400; ++i) {
        Vec3d p(0);
        p[axis] = half * (i / 200.0 - 1);
        p[(axis + 1) % 3] = side & 1 ? half : -half;
        p[(axis + 2) % 3] = side & 2 ? half : -half;
        const Vec3d at = place.point(p);
        if (std::fabs(solid.value(at)) < 1e-12 && std::fabs(other.value(at)) > 3 * voxel)
          points.push_back(at);
      }
  return points;
}

struct Loss {
  double largest = 0;
  double rms = 0;
};

Loss loss(const std::vector<Vec3d>& points, const mesh::Mesh& mesh, double voxel) {
  const mesh::MeshDistance distance(mesh);
  Loss found;
  for (const Vec3d& p : points) {
    const double d = distance.closest(p).distance / voxel;
    found.largest = std::max(found.largest, d);
    found.rms += d * d;
  }
  found.rms = std::sqrt(found.rms / static_cast<double>(points.size()));
  return found;
}

TEST(Crease, EdgesOfACutBoxArePreserved) {
  constexpr double kVoxel = 0.05;
  const CutBox box;
  std::vector<Vec3d> points =
      edge_points(box.outer, CutBox::kOuterHalf, box.solid, box.cut, kVoxel);
  const std::vector<Vec3d> dents =
      edge_points(box.inner, CutBox::kInnerHalf, box.solid, box.whole, kVoxel);
  points.insert(points.end(), dents.begin(), dents.end());
  ASSERT_GT(dents.size(), 300U);
  ASSERT_GT(points.size(), 3000U);

  PolygonizeOptions raw_options;
  raw_options.polish = false;
  const Loss raw = loss(points, polygonized(box.solid, kVoxel, raw_options).mesh, kVoxel);
  PolygonizeOptions round;
  round.creases = false;
  const Loss newton = loss(points, polygonized(box.solid, kVoxel, round).mesh, kVoxel);
  const PolygonizeResult found = polygonized(box.solid, kVoxel);
  const Loss sharp = loss(points, found.mesh, kVoxel);
  RecordProperty("raw_largest", std::to_string(raw.largest));
  RecordProperty("newton_largest", std::to_string(newton.largest));
  RecordProperty("sharp_largest", std::to_string(sharp.largest));
  RecordProperty("sharp_rms", std::to_string(sharp.rms));
  EXPECT_GT(raw.largest, 0.4);
  EXPECT_LT(sharp.largest, 0.05);
  EXPECT_LT(sharp.rms, 0.01);
  EXPECT_GT(newton.rms, 10 * sharp.rms);
  EXPECT_TRUE(mesh::self_intersections(found.mesh).empty());
}

// Gradients around a vertex of these solids differ by more than the crease angle, although nothing
// is sharp.
TEST(Crease, StrongCurvatureIsNotACrease) {
  constexpr double kVoxel = 0.05;
  for (const double radius : {2.0, 3.0}) {
    const field::Field ball = turned(field::make("sphere", {{"radius", radius * kVoxel}}),
                                     {1, 0, 0}, 0, {0.013, 0.007, -0.011});
    const PolygonizeResult found = polygonized(ball, kVoxel);
    EXPECT_EQ(found.report.crease_vertices, 0U);
    EXPECT_LT(found.report.rms_residual, 0.01);
  }
}

TEST(Crease, PlanesIntersectAtTheExpectedPoint) {
  RandomStream random{RandomKey(11)};
  const auto unit = [&] {
    const double x = random.normal();
    const double y = random.normal();
    return Vec3d(x, y, random.normal()).normalized();
  };
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3d corner = unit() * 3.0;
    std::vector<SurfacePoint> samples;
    std::array<Vec3d, 3> normals;
    do {
      for (Vec3d& n : normals) n = unit();
    } while (std::fabs(normals[0].cross(normals[1]).dot(normals[2])) < 0.4);
    for (const Vec3d& n : normals)
      for (int i = 0; i < 2; ++i) {
        const Vec3d side = unit();
        samples.push_back({corner + side - n * n.dot(side), n, 0});
      }
    EXPECT_LT((fit_planes(samples, corner + unit() * 0.5) - corner).length(), 1e-9);
  }
}

TEST(Crease, OnePlaneKeepsTheAnchor) {
  const std::vector<SurfacePoint> samples = {
      {{1, 0, 2}, {0, 0, 1}, 0}, {{-1, 1, 2}, {0, 0, 1}, 0}, {{0, 2, 2}, {0, 0, 1}, 0}};
  EXPECT_LT((fit_planes(samples, {5, 6, 7}) - Vec3d(5, 6, 2)).length(), 1e-12);
  EXPECT_EQ(min_normal_dot(samples), 1);
}

}  // namespace
}  // namespace vug::meshing
