// SPDX-License-Identifier: Apache-2.0
// Bump mapping by a vertex attribute bends normals like the same height as a function of position.
#include <gtest/gtest.h>
#include <vug/base/rng.h>
#include <vug/loading/load.h>
#include <vug/mesh/shapes.h>
#include <vug/render/prepared_scene.h>

#include <algorithm>
#include <cmath>

namespace vug::loading {
namespace {

/// A sphere whose vertices store their height twice: as a number and as a vector's mean.
mesh::MeshPtr ball() {
  mesh::Mesh made = mesh::sphere_mesh(Vec3d(0), 1, 5);
  mesh::Attribute one{"h", 1, {}}, three{"v", 3, {}};
  for (const Vec3f& p : made.positions) {
    made.normals.push_back(p);
    one.values.push_back(p.y);
    for (const float part : {0.0f, 3 * p.y - 1, 1.0f}) three.values.push_back(part);
  }
  made.attributes = {one, three};
  return std::make_shared<const mesh::Mesh>(std::move(made));
}

render::MaterialPtr bumpy(const std::string& mask) {
  const Loaded loaded =
      load_text("material sample = surface(bump: " + mask + ", bump_height: 40cm)\n", "t.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();  // warns about the unknown attribute
  return loaded.shot.materials.at(0).second;
}

TEST(Bump, ByAnAttributeEqualsThatByPosition) {
  const auto by_place = bumpy("height(from: -1m, to: 1m)");
  const render::MaterialPtr by_number[] = {bumpy("attribute(name: \"h\", from: -1, to: 1)"),
                                           bumpy("attribute(name: \"v\", from: -1, to: 1)")};
  const Transform turned = Transform::translation({5, 1, 2}) * Transform::rotation({1, 2, 3}, 1.1) *
                           Transform::scaling(Vec3d(0.5));
  for (const bool instance : {false, true}) {
    render::Scene scene;
    scene.objects.resize(1);
    scene.objects[0].mesh = ball();
    if (instance)
      scene.objects[0].instance = std::make_shared<const render::InstanceTransform>(turned);
    const render::PreparedScene world(scene);
    RandomStream random(RandomKey(3));
    double bent = 0;
    const int kRays = 500;
    for (int i = 0; i < kRays; ++i) {
      Vec3d way;
      for (int k = 0; k < 3; ++k) way[k] = random.uniform() - 0.5;
      const Vec3f out(way.normalized());
      const Vec3f from = Vec3f(world.bounds().center()) + out * 3.0f;
      render::Hit hit;
      ASSERT_TRUE(world.intersect({from, -out}, hit));
      const Vec3f smooth = hit.surface.shading_normal;
      render::Surface expected = hit.surface;
      ASSERT_TRUE(by_place->bump(expected));
      for (const render::MaterialPtr& material : by_number) {
        render::Surface found = hit.surface;
        ASSERT_TRUE(material->bump(found));
        // Triangle edges span 3 degrees.
        EXPECT_GT(found.shading_normal.dot(expected.shading_normal), std::cos(0.02f));
      }
      bent += 1 - static_cast<double>(smooth.dot(expected.shading_normal));
    }
    EXPECT_GT(bent / kRays, 0.01);
  }
}

}  // namespace
}  // namespace vug::loading
