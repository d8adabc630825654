// SPDX-License-Identifier: Apache-2.0
// Solids from files: meshes, images and level sets, compared with closed forms; bad files are
// rejected.
#include "fixtures.h"

#include <vug/field/heightmap.h>
#include <vug/field/registry.h>
#include <vug/field/sampled.h>
#include <vug/image/io.h>
#include <vug/mesh/format.h>
#include <vug/mesh/shapes.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

std::string file(const std::string& name) { return fixture_folder() + "/" + name; }

std::string fault_of(const std::string& kind,
                     const std::vector<std::pair<std::string, Value>>& params) {
  try {
    make(kind, params);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::bad_input);
    return e.what();
  }
  return "";
}

TEST(MeshPrimitive, BoxMeshEqualsTheBox) {
  mesh::write_mesh(mesh::box_mesh({Vec3d(-1, -2, -3), Vec3d(1, 2, 3)}), file("box.obj"));
  const Field from_file = make("mesh", {{"file", file("box.obj")}, {"scale", 0.5}});
  const Field box = make("box", {{"size", Vec3d(1, 2, 3)}});
  for (const Vec3d& p :
       {Vec3d(0.1, 0.2, 0), Vec3d(2, 0, 0), Vec3d(2, 3, 4), Vec3d(0.1, 0.9, 0.3)}) {
    EXPECT_NEAR(from_file.value(p), box.value(p), 1e-7) << p;
    EXPECT_LT((from_file.gradient(p).gradient - box.gradient(p).gradient).length(), 1e-6) << p;
  }
  EXPECT_EQ(from_file.bounds().max, Vec3d(0.5, 1, 1.5));
}

TEST(MeshPrimitive, OpenMeshesAreRefusedWithTheirEdgeCounts) {
  mesh::Mesh open = mesh::box_mesh({Vec3d(0), Vec3d(1)});
  open.triangles.pop_back();
  mesh::write_mesh(open, file("open.ply"));
  EXPECT_NE(fault_of("mesh", {{"file", file("open.ply")}}).find("3 open edges"), std::string::npos);
  EXPECT_NE(fault_of("mesh", {{"file", file("none.ply")}}), "");
}

TEST(Heightfield, RampIsAPlane) {
  image::Image ramp(2, 2, {"Y"});
  ramp.at(1, 0) = ramp.at(1, 1) = 1;
  image::write_exr(file("ramp.exr"), ramp);
  const Field f = make("heightfield", {{"file", file("ramp.exr")},
                                       {"size", Vec3d(2, 1, 2)},
                                       {"base", 0.5},
                                       {"sampling", Value::Name{"bilinear"}}});
  // The top is y = (x + 1) / 2, so the value above it is the distance to that plane.
  EXPECT_NEAR(f.value({0, 1.5, 0}), 1 / std::sqrt(1.25), 1e-12);
  EXPECT_NEAR(f.value({0.5, 0.75, 0.2}), 0, 1e-12);
  EXPECT_NEAR(f.value({0, -2.5, 0}), 2, 1e-12);
  EXPECT_NEAR(f.value({4, -4.5, 0}), 5, 1e-12);
  EXPECT_EQ(f.bounds().min, Vec3d(-1, -0.5, -1));
}

TEST(Heightfield, TheTopRowOfThePictureLiesTowardsMinusZ) {
  image::Image edge(3, 3, {"Y"});
  for (int x = 0; x < 3; ++x) edge.at(x, 0) = 1;
  image::write_exr(file("edge.exr"), edge);
  const Field f = make("heightfield", {{"file", file("edge.exr")}, {"size", Vec3d(2, 1, 2)}});
  EXPECT_LT(f.value({0, 0.9, -0.99}), 0);
  EXPECT_GT(f.value({0, 0.9, 0.99}), 0);
}

TEST(Heightmap, CubicReproducesParabolasAwayFromTheEdges) {
  std::vector<float> heights;
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) heights.push_back(static_cast<float>(i * i - 2 * i * j + j));
  const Heightmap heightmap(6, 6, heights, 5, 5, Sampling::bicubic);
  for (double u = 1; u <= 4; u += 0.37)
    for (double v = 1; v <= 4; v += 0.41) {
      const Heightmap::Height h = heightmap.at(u, v);
      EXPECT_NEAR(h.value, u * u - 2 * u * v + v, 1e-12);
      EXPECT_NEAR(h.slope_u, 2 * u - 2 * v, 1e-12);
      EXPECT_NEAR(h.slope_v, 1 - 2 * u, 1e-12);
    }
}

TEST(GridPrimitive, GrowsWithTheDistanceBeyondItsBand) {
  const Field ball = make("grid", {{"file", fixture_file("grid")}});
  EXPECT_NEAR(ball.value({1.1, 0, 0}), 0.1, 1e-12);
  EXPECT_NEAR(ball.value({0, 0, 0}), -0.3, 1e-12);
  EXPECT_NEAR(ball.value({5, 0, 0}), 5 - 1.3, 1e-12);
}

}  // namespace
}  // namespace vug::field
