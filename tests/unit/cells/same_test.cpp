// SPDX-License-Identifier: Apache-2.0
// Changes that must not affect a network, and input that is rejected.
#include "made.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace vug::cells {
namespace {

TEST(SameBytes, ForAnyNumberOfThreadsAndOrderOfPolygons) {
  const mesh::Mesh torus = mesh::torus_mesh(1, 0.4, 60, 30);
  mesh::Mesh shuffled = torus;
  RandomStream random(RandomKey(5));
  for (size_t i = shuffled.triangles.size(); i > 1; --i)
    std::swap(shuffled.triangles[i - 1],
              shuffled.triangles[random.below(static_cast<uint32_t>(i))]);
  std::rotate(shuffled.triangles[7].begin(), shuffled.triangles[7].begin() + 1,
              shuffled.triangles[7].end());
  for (const GridKind* kind : grids()) {
    BuildOptions o = options(kind->info.name, 0.06);
    o.relax = 3;
    const Digest expected = digest(build(Surface({shared(torus)}), o).network);
    for (const int threads : {1, 2, 5, 8}) {
      with_threads(threads, [&] {
        EXPECT_EQ(digest(build(Surface({shared(shuffled)}), o).network), expected)
            << kind->info.name << " " << threads;
      });
    }
    o.key = RandomKey(1);
    EXPECT_NE(digest(build(Surface({shared(torus)}), o).network), expected) << kind->info.name;
  }
}

TEST(SameCells, ForAnyTriangulationOfAPolygon) {
  // The floor as two triangles, and as a fan around an arbitrary point.
  const mesh::Mesh plain = floor_mesh();
  mesh::Mesh fan = plain;
  fan.positions.push_back({0.3f, 0, 0.55f});
  fan.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  BuildOptions o = options("triangle", 0.02);
  o.grid.gap = 100;  // No darts, because those depend on the triangles.
  const Network a = build(Surface({shared(plain)}), o).network;
  const Network b = build(Surface({shared(fan)}), o).network;
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i)
    ASSERT_LT((a.position[i] - b.position[i]).length(), 1e-5f) << i;
}

TEST(SameCells, DistantAdditionsChangeNothing) {
  const mesh::MeshPtr ball = shared(mesh::sphere_mesh(Vec3d(0), 1, 3));
  const mesh::MeshPtr far = shared(mesh::sphere_mesh(Vec3d(9, 1, 1), 1, 2));
  BuildOptions o = options("random", 0.1);
  o.relax = 0;  // Pushes are summed in another order, which affects their last bits.
  std::vector<Vec3f> alone = build(Surface({ball}), o).network.position;
  std::vector<Vec3f> here;
  for (const Vec3f& p : build(Surface({far, ball}), o).network.position)
    if (p.x < 3) here.push_back(p);
  const auto before = [](const Vec3f& a, const Vec3f& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(alone.begin(), alone.end(), before);
  std::sort(here.begin(), here.end(), before);
  EXPECT_EQ(here.size(), alone.size());
  EXPECT_EQ(here, alone);
}

struct Refusal {
  ErrorCode code;
  std::string message;
};

Refusal refusal(const std::vector<mesh::MeshPtr>& objects, double spacing = 0.1) {
  try {
    build(Surface(objects), options("random", spacing));
  } catch (const Error& error) {
    return {error.code(), error.what()};
  }
  return {ErrorCode::internal, "nothing was refused"};
}

TEST(BadInput, IsRefusedInASentence) {
  const mesh::Mesh good = mesh::box_mesh({Vec3d(0), Vec3d(1)});
  mesh::Mesh mesh = good;
  mesh.positions[3].y = std::nanf("");
  EXPECT_EQ(refusal({shared(mesh)}).code, ErrorCode::bad_input);
  mesh = good;
  mesh.triangles[4][1] = 99;
  EXPECT_EQ(refusal({shared(mesh)}).code, ErrorCode::bad_input);
  mesh = good;
  std::swap(mesh.triangles[4][1], mesh.triangles[4][2]);
  EXPECT_EQ(refusal({shared(good), shared(mesh)}).message,
            "the polygons of object 2 disagree about the outside: 3 edges");
  mesh = good;
  for (Vec3f& p : mesh.positions) p.x = 0, p.y = 0;
  EXPECT_EQ(refusal({shared(mesh)}).message, "the object has no surface for cells");
  EXPECT_EQ(refusal({}).message, "there is no object for cells");
  EXPECT_EQ(refusal({shared(good)}, 1.9).message,
            "cells 1.9 m apart are larger than the object, which is 1.732 m");
  EXPECT_EQ(refusal({shared(good)}, 1e-4).code, ErrorCode::too_large);
  EXPECT_EQ(refusal({shared(good)}, 1e-9).code, ErrorCode::too_large);
  EXPECT_EQ(refusal({shared(good)}, 0).code, ErrorCode::bad_input);
  EXPECT_EQ(refusal({shared(good)}, std::nan("")).code, ErrorCode::bad_input);
}

TEST(OpenMeshes, AndSliversAreFine) {
  mesh::Mesh mesh = mesh::sphere_mesh(Vec3d(0), 1, 3);
  mesh.triangles.erase(mesh.triangles.begin() + 17);  // The rabbit of figure 10.
  mesh.triangles.push_back({4, 4, 9});
  const Network n = build(Surface({shared(mesh)}), options("random", 0.05)).network;
  validate(n);
  const std::vector<uint32_t> piece = components(n.links);
  EXPECT_EQ(*std::max_element(piece.begin(), piece.end()), 0u);
}

}  // namespace
}  // namespace vug::cells
