// SPDX-License-Identifier: Apache-2.0
#include "solids.h"

#include <vug/base/parallel.h>
#include <vug/field/noise.h>
#include <vug/mesh/folds.h>
#include <vug/mesh/refine.h>
#include <vug/mesh/self_intersections.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/topology.h>
#include <vug/mesh/weld.h>
#include <vug/meshing/dice.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace vug::meshing {
namespace {

field::Field sphere(double radius) { return field::make("sphere", {{"radius", radius}}); }

/// A sphere with bumps much smaller than its voxels.
field::Field rough_sphere() {
  const field::Noise fbm = field::make_noise("fbm", {{"scale", 0.2}, {"octaves", 3}});
  return field::make(
      "displace",
      {{"field", field::as_value(sphere(1))}, {"noise", field::as_value(fbm)}, {"amount", 0.02}});
}

DiceOptions edges_of(double longest, int levels = 9) {
  return {[longest](const Vec3d&) { return longest; }, levels, 0.05};
}

/// Shorter edges towards +x.
DiceOptions graded(double longest) {
  return {[longest](const Vec3d& p) { return longest * (1.2 - p.x); }, 9, 0.05};
}

void expect_closed(const mesh::Mesh& mesh) {
  const mesh::Topology topology = mesh::inspect(mesh);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.misoriented_edges, 0U);
  EXPECT_EQ(topology.nonmanifold_vertices, 0U);
  EXPECT_EQ(topology.unused_vertices, 0U);
  EXPECT_EQ(topology.genus, 0U);
}

TEST(Dice, RoughSurfacesStayClosedAndTheirVerticesAreOnTheField) {
  const field::Field field = rough_sphere();
  const mesh::Mesh base = polygonized(field, 0.12).mesh;
  const DiceOptions options = graded(0.02);
  const DiceResult diced = dice(base, field, options);
  expect_closed(diced.mesh);
  EXPECT_GT(diced.mesh.triangles.size(), 20 * base.triangles.size());
  EXPECT_EQ(diced.report.added_vertices, diced.mesh.positions.size() - base.positions.size());
  EXPECT_EQ(diced.report.unfollowed, 0U);
  EXPECT_TRUE(mesh::folded_triangles(diced.mesh).empty());
  EXPECT_TRUE(mesh::self_intersections(diced.mesh).empty());
  for (const Vec3f& p : diced.mesh.positions) {
    const field::Gradient at = field.gradient(Vec3d(p));
    ASSERT_LT(std::fabs(at.value), 0.05 * options.edge_length(Vec3d(p)) * at.gradient.length());
  }
  for (const mesh::Triangle& t : diced.mesh.triangles)
    for (size_t k = 0; k < 3; ++k) {
      const Vec3d a(diced.mesh.positions[t[k]]), b(diced.mesh.positions[t[(k + 1) % 3]]);
      const double longest = std::min(options.edge_length(a), options.edge_length(b));
      ASSERT_LE((a - b).length(), longest * (1 + 1e-5));
    }
}

TEST(Dice, SpheresApproachTheirVolumeAndHaveRadialNormals) {
  const mesh::Mesh base = polygonized(sphere(1), 0.25).mesh;
  const auto lost = [](const mesh::Mesh& mesh) { return 4 * kPi / 3 - volume_of(mesh); };
  const DiceResult diced = dice(base, sphere(1), edges_of(0.02));
  EXPECT_LT(lost(diced.mesh), 2e-3);
  // The chords of half the length lose a quarter of the volume.
  EXPECT_NEAR(lost(dice(base, sphere(1), edges_of(0.01)).mesh) / lost(diced.mesh), 0.25, 0.1);
  for (size_t v = 0; v < diced.mesh.positions.size(); ++v)
    ASSERT_GT(diced.mesh.normals[v].dot(diced.mesh.positions[v].normalized()), 1 - 1e-5);
}

TEST(Dice, EdgesOfSolidsStaySharp) {
  const Vec3d half(0.7, 0.5, 0.3);
  const field::Field box = field::make("box", {{"size", half * 2}});
  const DiceResult diced = dice(polygonized(box, 0.1).mesh, box, edges_of(0.03));
  expect_closed(diced.mesh);
  EXPECT_NEAR(volume_of(diced.mesh), 8 * half.x * half.y * half.z, 1e-4);
}

TEST(Dice, TheSameBytesForAnyNumberOfThreads) {
  const field::Field field = rough_sphere();
  mesh::Mesh base = polygonized(field, 0.12).mesh;
  base.attributes.push_back({"x", 1, {}});
  for (const Vec3f& p : base.positions) base.attributes[0].values.push_back(p.x);
  const auto run = [&](int threads) {
    return with_threads(threads, [&] { return dice(base, field, graded(0.03)).mesh; });
  };
  const mesh::Mesh one = run(1);
  EXPECT_TRUE(one == run(2));
  EXPECT_TRUE(one == run(7));
}

TEST(Dice, PartsOfAMeshGiveTheTrianglesOfTheWhole) {
  const field::Field field = rough_sphere();
  const mesh::Mesh base = polygonized(field, 0.12).mesh;
  mesh::Mesh part = base;
  part.triangles.resize(base.triangles.size() / 3);
  part = mesh::without_unused_vertices(part);
  const auto corners = [](const mesh::Mesh& mesh) {
    std::set<std::array<float, 9>> all;
    for (const mesh::Triangle& t : mesh.triangles) {
      std::array<float, 9> numbers{};
      for (size_t k = 0; k < 3; ++k)
        for (size_t axis = 0; axis < 3; ++axis)
          numbers[3 * k + axis] = mesh.positions[t[k]][static_cast<int>(axis)];
      all.insert(numbers);
    }
    return all;
  };
  const auto whole = corners(dice(base, field, graded(0.05)).mesh);
  const auto own = corners(dice(part, field, graded(0.05)).mesh);
  EXPECT_GT(own.size(), 3 * part.triangles.size());
  EXPECT_TRUE(std::includes(whole.begin(), whole.end(), own.begin(), own.end()));
}

TEST(Dice, DetailOutOfReachLeavesTheMiddlesOfEdgesAndIsCounted) {
  const mesh::Mesh base = mesh::box_mesh(Box3d(Vec3d(-1), Vec3d(1)));
  const DiceResult diced = dice(base, sphere(9), edges_of(0.5));
  EXPECT_EQ(diced.report.unfollowed, diced.mesh.positions.size());
  const mesh::Mesh flat = mesh::refined(base, 0.5);
  const auto sorted = [](std::vector<Vec3f> points) {
    std::sort(points.begin(), points.end(), [](const Vec3f& a, const Vec3f& b) {
      return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    return points;
  };
  EXPECT_EQ(sorted(diced.mesh.positions), sorted(flat.positions));
}

TEST(Dice, LevelsLimitTheDivision) {
  const mesh::Mesh base = mesh::box_mesh(Box3d(Vec3d(-1), Vec3d(1)));
  const field::Field box = field::make("box", {{"size", Vec3d(2)}});
  EXPECT_EQ(dice(base, box, edges_of(1e-3, 2)).mesh.triangles.size(), 16 * base.triangles.size());
  EXPECT_EQ(dice(base, box, edges_of(9)).mesh.triangles, base.triangles);
  EXPECT_TRUE(dice({}, sphere(1), edges_of(1)).mesh.triangles.empty());
}

TEST(Dice, AttributesAreInterpolated) {
  const field::Field box = field::make("box", {{"size", Vec3d(2)}});
  mesh::Mesh base = mesh::box_mesh(Box3d(Vec3d(-1), Vec3d(1)));
  base.attributes.push_back({"place", 3, {}});
  for (const Vec3f& p : base.positions)
    for (int axis = 0; axis < 3; ++axis) base.attributes[0].values.push_back(p[axis]);
  const DiceResult result = dice(base, box, edges_of(0.3));
  EXPECT_EQ(result.report.unfollowed, 0U);
  const mesh::Mesh& diced = result.mesh;
  for (size_t v = 0; v < diced.positions.size(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(diced.attributes[0].values[3 * v + static_cast<size_t>(axis)],
                  diced.positions[v][axis], 1e-5);
}

TEST(Dice, TheNumberOfTrianglesIsEstimatedWithinFivePercent) {
  for (const field::Field& field : {rough_sphere(), sphere(1)}) {
    const mesh::Mesh base = polygonized(field, 0.04).mesh;
    for (const DiceOptions& options : {edges_of(0.012), graded(0.02)}) {
      const auto diced = static_cast<double>(dice(base, field, options).mesh.triangles.size());
      EXPECT_NEAR(estimate_diced_triangles(base, field, options) / diced, 1, 0.05);
    }
  }
}

// A request far beyond any memory is estimated without making its triangles.
TEST(Dice, HugeNumbersOfTrianglesAreEstimatedFromAreas) {
  const mesh::Mesh base = polygonized(sphere(1), 0.1).mesh;
  EXPECT_GT(estimate_diced_triangles(base, sphere(1), edges_of(1e-5, 14)), 1e10);
}

}  // namespace
}  // namespace vug::meshing
