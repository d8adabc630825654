// SPDX-License-Identifier: Apache-2.0
// The masks by which materials are layered, compared with analytic values; and the presets in
// data/materials with their wet variants.
#include <gtest/gtest.h>
#include <vug/loading/load.h>

#include <cmath>

namespace vug::loading {
namespace {

using render::Surface;

render::MaterialPtr find(const shot::Shot& shot, const std::string& name) {
  for (const auto& [each, material] : shot.materials)
    if (each == name) return material;
  return nullptr;
}

render::MaterialPtr made(const std::string& text) {
  const Loaded loaded = load_text("material sample = " + text + "\n", "t.vug");
  EXPECT_EQ(loaded.report(), "") << text;
  return find(loaded.shot, "sample");
}

Surface at(const Vec3f& position, const Vec3f& normal = {0, 1, 0}) {
  Surface surface;
  surface.position = position;
  surface.geometric_normal = surface.shading_normal = normal;
  return surface;
}

/// White under the mask, black elsewhere: its albedo is the mask.
struct Masked {
  render::MaterialPtr mixed, painted;

  explicit Masked(const std::string& mask)
      : mixed(made("mix(a: lambert(albedo: (0, 0, 0)), b: lambert(albedo: (1, 1, 1)), mask: " +
                   mask + ")")),
        painted(made("surface(specular: 0, matte: 0, color: layer(under: (0, 0, 0), over: (1, 1, "
                     "1), mask: " +
                     mask + "))")) {}
  /// The same result by mixing materials and by painting one.
  double operator()(const Surface& surface) const {
    render::BsdfMemory memory, more;
    const auto a = static_cast<double>(mixed->at(surface, {0, 0, 1}, memory).albedo().x);
    const auto b = static_cast<double>(painted->at(surface, {0, 0, 1}, more).albedo().x);
    EXPECT_NEAR(a, b, 1e-5);
    return a;
  }
};

Vec3f leaning(double degrees) {
  const double angle = degrees * kPi / 180;
  return {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0};
}

TEST(Layering, BySlope) {
  const Masked flat("slope(from: 60deg, to: 20deg)");
  EXPECT_NEAR(flat(at({0, 0, 0}, leaning(10))), 1, 1e-6);
  EXPECT_NEAR(flat(at({0, 0, 0}, leaning(40))), 0.5, 1e-5);
  EXPECT_NEAR(flat(at({0, 0, 0}, leaning(30))), 0.84375, 1e-5);  // 3 t^2 - 2 t^3 at 3/4
  EXPECT_NEAR(flat(at({0, 0, 0}, leaning(95))), 0, 1e-6);
}

TEST(Layering, ByHeight) {
  const Masked high("height(from: 1m, to: 3m)");
  EXPECT_NEAR(high(at({7, 1, 0})), 0, 1e-6);
  EXPECT_NEAR(high(at({-2, 2, 5})), 0.5, 1e-6);
  EXPECT_NEAR(high(at({0, 3.5f, 0})), 1, 1e-6);
}

TEST(Layering, ByDistanceToAnotherField) {
  const Masked close("near(field: sphere(1m), from: 2m, to: 0m)");
  EXPECT_NEAR(close(at({0, 2, 0})), 0.5, 1e-6);
  EXPECT_NEAR(close(at({0, 0, 1})), 1, 1e-6);
  EXPECT_NEAR(close(at({4, 0, 0})), 0, 1e-6);
}

// Strata are horizontal: constant along a bed, varying across beds.
TEST(Layering, ByStrata) {
  const Masked bed("noise(noise: beds(thickness: 50cm, wander: 0m), from: -0.6, to: 0.6)");
  double least = 1, most = 0;
  for (int i = 0; i < 40; ++i) {
    const float y = -3 + 0.151f * static_cast<float>(i);
    const double here = bed(at({0, y, 0}));
    EXPECT_NEAR(bed(at({31, y, -17})), here, 1e-5);
    least = std::min(least, here), most = std::max(most, here);
  }
  EXPECT_LT(least, 0.2);
  EXPECT_GT(most, 0.8);
}

TEST(Layering, ByMasksOfMasks) {
  const Masked both("multiply([height(from: 0m, to: 2m), slope(from: 60deg, to: 20deg)])");
  EXPECT_NEAR(both(at({0, 1, 0}, leaning(40))), 0.25, 1e-5);
  const Masked part("between(mask: height(from: 0m, to: 2m), from: 0.8, to: 0.2)");
  EXPECT_NEAR(part(at({0, 1, 0})), 0.5, 1e-5);
}

// A height that rises along y tilts the normal of a vertical wall against it by the angle of the
// slope, 1.5 per metre in the middle of the ramp.
TEST(Layering, BumpTiltsTheNormalByTheSlope) {
  const auto material = made("surface(bump: height(from: 0m, to: 1m), bump_height: 50cm)");
  for (const bool inside : {false, true}) {
    Surface wall = at({0, 0.5f, 0}, {0, 0, 1});
    wall.inside = inside;
    ASSERT_TRUE(material->bump(wall));
    // Height points out of the rock, away from a viewer inside the wall.
    const float down = inside ? 1 : -1;
    const float size = std::sqrt(1 + 0.75f * 0.75f);
    EXPECT_NEAR(wall.shading_normal.y, down * 0.75f / size, 0.01f) << inside;
    EXPECT_NEAR(wall.shading_normal.z, 1 / size, 0.01f);
    EXPECT_EQ(wall.geometric_normal, Vec3f(0, 0, 1));
  }
  Surface beyond = at({0, 3, 0}, {0, 0, 1});
  material->bump(beyond);
  EXPECT_NEAR(beyond.shading_normal.z, 1, 1e-6);
  EXPECT_FALSE(made("surface()")->bump(beyond));
}

// Wet rock is darker than dry rock of the same kind, and has a highlight.
TEST(Presets, WetVariantsAreDarkerAndShine) {
  for (const std::string name :
       {"limestone", "calcite", "basalt", "sandstone", "granite", "mud", "moss", "ice"}) {
    SCOPED_TRACE(name);
    LoadOptions options;
    options.include_folders = {VUG_DATA};
    const Loaded loaded = load_text("include \"materials/" + name + ".vug\"\n", "t.vug", options);
    ASSERT_EQ(loaded.report(), "");
    const auto dry = find(loaded.shot, name), wet = find(loaded.shot, "wet_" + name);
    ASSERT_TRUE(dry && wet);
    const auto seen = [](const render::MaterialPtr& material, const Vec3f& in) {
      render::BsdfMemory memory;
      const Vec3f out = Vec3f(0.5f, 0, 0.8660254f);
      return material->at(at({0.1f, 0.2f, 0.3f}), out, memory).evaluate(in).total().y;
    };
    const Vec3f mirrored(-0.5f, 0, 0.8660254f), aside = Vec3f(0, 0.9f, 0.43588989f);
    EXPECT_GT(seen(wet, mirrored), 2 * seen(dry, mirrored));
    if (name != "ice") {
      EXPECT_LE(seen(wet, aside), seen(dry, aside));
    }
  }
}

}  // namespace
}  // namespace vug::loading
