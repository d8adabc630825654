// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/field/registry.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/weld.h>
#include <vug/metrics/cells.h>
#include <vug/metrics/report.h>
#include <vug/metrics/surface.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace vug::metrics {
namespace {

const Box3d kUnitBox(Vec3d(0), Vec3d(1));

Convexity bends(const mesh::Mesh& mesh) { return convexity(mesh, mesh::find_edges(mesh)); }

TEST(Surface, OfABoxIsExact) {
  const mesh::Mesh mesh = mesh::box_mesh({Vec3d(-1, 2, 3), Vec3d(1, 5, 7)});
  EXPECT_DOUBLE_EQ(area(mesh), 2 * (2 * 3 + 3 * 4 + 4 * 2));
  EXPECT_DOUBLE_EQ(volume(mesh), 24);
}

// A polyhedron inscribed in a smooth surface has an error of O(h^2).
TEST(Surface, OfSphereAndTorusConvergesAtSecondOrder) {
  const double sphere_area = 4 * kPi;
  const double torus_volume = 2 * kPi * kPi * 2 * 0.25;
  const double coarse = sphere_area - area(mesh::sphere_mesh(Vec3d(0), 1, 3));
  const double fine = sphere_area - area(mesh::sphere_mesh(Vec3d(0), 1, 4));
  EXPECT_NEAR(coarse / fine, 4, 0.1);
  const double coarse_torus = torus_volume - volume(mesh::torus_mesh(2, 0.5, 40, 20));
  const double fine_torus = torus_volume - volume(mesh::torus_mesh(2, 0.5, 80, 40));
  EXPECT_NEAR(coarse_torus / fine_torus, 4, 0.1);
}

TEST(Surface, SumsDoNotDependOnThreads) {
  const mesh::Mesh mesh = mesh::torus_mesh(2, 0.7, 200, 100);
  const double reference = area(mesh);
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] { EXPECT_EQ(area(mesh), reference); });
  }
}

TEST(Convexity, OfConvexBodiesIs100AndFlipsWithTheNormals) {
  for (mesh::Mesh mesh : {mesh::box_mesh(kUnitBox), mesh::sphere_mesh({3, 0, 0}, 2, 3)}) {
    EXPECT_EQ(bends(mesh).cf(), 100);
    EXPECT_EQ(bends(mesh).cf_area(), 100);
    for (mesh::Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
    EXPECT_EQ(bends(mesh).cf(), 0);
  }
  EXPECT_EQ(bends(mesh::box_mesh(kUnitBox)).convex, 12U) << "the diagonals of faces are flat";
  EXPECT_FALSE(bends(mesh::Mesh{}).cf().has_value());
}

// Seen from outside, the half of a torus around its hole is a saddle: edges around the tube remain
// convex there, edges along the tube become concave.
TEST(Convexity, OfATorusIsMixed) {
  const Convexity found = bends(mesh::torus_mesh(2, 0.5, 48, 24));
  EXPECT_GT(*found.cf(), 50);
  EXPECT_LT(*found.cf(), 90);
  EXPECT_GT(*found.cf_area(), *found.cf()) << "the outer half is larger";
}

TEST(Cells, OfTheUnitSphereMatchTheTable) {
  const field::Field sphere = field::make("sphere", {{"radius", 1.0}});
  const struct {
    int density;
    uint64_t cells;
  } table[] = {{1, 0}, {2, 8}, {4, 136}, {8, 1568}, {10, 3280}, {16, 14784}, {32, 127632}};
  for (const auto& row : table)
    EXPECT_EQ(inside_cells(sphere, 1.0 / row.density), row.cells) << row.density;
}

TEST(Cells, OfAnEmptyFieldAreZero) { EXPECT_EQ(inside_cells(field::Field(), 0.1), 0U); }

TEST(Report, DescribesTwoOverlappingBoxes) {
  const Report report =
      measure(mesh::joined(mesh::box_mesh(kUnitBox), mesh::box_mesh({Vec3d(0.5), Vec3d(1.5)})));
  EXPECT_EQ(report.components, 2U);
  EXPECT_EQ(report.genus, 0U);
  EXPECT_GT(report.self_intersections, 0U);
  EXPECT_TRUE(report.is_closed_solid());
  EXPECT_EQ(report.bounds, Box3d(Vec3d(0), Vec3d(1.5)));
}

TEST(Report, JsonHasTheKeysInOrderAndNullForTheUnknown) {
  Report report = measure(mesh::box_mesh(kUnitBox));
  const auto json = nlohmann::ordered_json::parse(to_json(report));
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  EXPECT_EQ(keys, (std::vector<std::string>{"area",
                                            "volume",
                                            "volume_cells",
                                            "cf",
                                            "cf_area",
                                            "vertices",
                                            "triangles",
                                            "productions",
                                            "build_seconds",
                                            "components",
                                            "genus",
                                            "boundary_edges",
                                            "nonmanifold_edges",
                                            "misoriented_edges",
                                            "zero_area_triangles",
                                            "folded_triangles",
                                            "self_intersections",
                                            "invalid_places",
                                            "small_features",
                                            "bounds"}));
  EXPECT_EQ(json["area"], 6.0);
  EXPECT_EQ(json["cf"], 100.0);
  EXPECT_TRUE(json["productions"].is_null());
  EXPECT_EQ(json["bounds"][1][2], 1.0);
  report.productions = 12;
  EXPECT_EQ(nlohmann::json::parse(to_json(report))["productions"], 12);
  EXPECT_NE(to_table(report).find("productions         12\n"), std::string::npos);
}

TEST(Report, OfAnEmptyMesh) {
  const Report report = measure(mesh::Mesh{});
  EXPECT_EQ(report.components, 0U);
  EXPECT_TRUE(nlohmann::json::parse(to_json(report))["bounds"].is_null());
}

}  // namespace
}  // namespace vug::metrics
