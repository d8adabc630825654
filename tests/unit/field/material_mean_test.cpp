// SPDX-License-Identifier: Apache-2.0
// Numbers of materials as fields: hardness that scales displacements, radii of blends, and the
// continuity of the surfaces that depend on them.
#include <vug/base/rng.h>
#include <vug/field/boolean.h>
#include <vug/field/displace.h>
#include <vug/field/material_pair_kind.h>
#include <vug/field/material_source.h>
#include <vug/field/noise.h>

#include "rocks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

Value pair(const std::string& a, const std::string& b, double radius) {
  return Object{"material pair", MaterialPair{{a, b}, radius}};
}
Noise softness(const Field& rock, double contact, double exponent = 1) {
  return make_noise("softness",
                    {{"of", as_value(rock)}, {"contact", contact}, {"exponent", exponent}});
}
/// The largest slope between random neighbours.
double sampled_slope(const Field& field, double reach, double step) {
  RandomStream random(RandomKey(21));
  double most = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto draw = [&](double r) {
      const double x = random.uniform(-r, r), y = random.uniform(-r, r);
      return Vec3d(x, y, random.uniform(-r, r));
    };
    const Vec3d p = draw(reach), way = draw(step);
    if (way.length() > 0)
      most = std::max(most, std::fabs(field.value(p + way) - field.value(p)) / way.length());
  }
  return most;
}

TEST(MaterialMeans, SoftnessIsTheFactorOfEachMaterial) {
  const Noise n = softness(two_rocks(), 0.3, 2);
  EXPECT_DOUBLE_EQ(n.field.value({0, 0.2, 0}), 1);  // (1 - 0)^2 as a mask: 2 * 1 - 1.
  EXPECT_DOUBLE_EQ(n.field.value({0, -0.2, 0}), 2 * 0.25 * 0.25 - 1);
  EXPECT_NEAR(n.field.value({0, 0, 0}), 0.5 * (1 + 2 * 0.0625 - 1), 1e-12);
  // Moved rock has its hardness moved, at every scale.
  const Transform map = Transform::translation({1, 2, 3}) * Transform::scaling({2, 2, 2});
  const Noise moved = softness(transformed(two_rocks(), map), 0.3, 2);
  EXPECT_DOUBLE_EQ(moved.field.value({1, 2.7, 3}), 1);
  EXPECT_DOUBLE_EQ(moved.field.value({1, 1.3, 3}), 2 * 0.0625 - 1);
}

TEST(MaterialMeans, HardnessScalesADisplacement) {
  const Field rock = two_rocks();
  const Noise noise = default_noise("perlin").value();
  Displacement options;
  options.amount = 0.2;
  options.by = softness(rock, 0.3);
  const Field moved = displaced(rock, noise, options);
  for (double x = -1; x <= 1; x += 0.13) {
    const Vec3d soft(x, 1, 3.9), hard(x, -1, 3.9);
    EXPECT_NEAR(moved.value(soft), rock.value(soft) - 0.2 * noise.field.value(soft), 1e-12);
    EXPECT_NEAR(moved.value(hard), rock.value(hard) - 0.25 * 0.2 * noise.field.value(hard), 1e-12);
  }
}

TEST(MaterialMeans, UnionsAndMorphsMixTheirNumbers) {
  const Field soft = of(orb(), "clay"), hard = of(shifted(orb(), {3, 0, 0}), "chert", 1);
  const Noise both = softness(unite({soft, hard}), 0.5);
  EXPECT_DOUBLE_EQ(both.field.value({0, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(both.field.value({3, 0, 0}), -1);
  EXPECT_NEAR(both.field.value({1.5, 0.4, 0}), 0, 1e-12);
  EXPECT_NEAR(softness(morph(soft, hard, 0.25), 0.5).field.value({7, 1, 2}), 0.5, 1e-12);
  // A cut does not count, nor a part without a material.
  EXPECT_DOUBLE_EQ(softness(subtract(soft, {hard, orb()}), 0.5).field.value({3, 0, 0}), 1);
}

/// A ball of limestone on rock of two materials, with radii that differ by 0.4 m.
Field blended(double contact, double other = 0.1) {
  return make(
      "union_by_material",
      {{"a", as_value(of(shifted(orb(), {0, 0, 4.5}), "limestone"))},
       {"b", as_value(two_rocks())},
       {"radii", List{pair("limestone", "shale", 0.5), pair("limestone", "limestone", other)}},
       {"contact", contact}});
}

TEST(MaterialMeans, TheRadiusOfABlendIsThatOfThePair) {
  const Field a = shifted(orb(), {0, 0, 4.5}), b = cube();
  const Blend wide{Profile::smooth, 0.5}, narrow{Profile::smooth, 0.1};
  const Field field = blended(0.8);
  RandomStream random(RandomKey(22));
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(0.41, 1);
    const Vec3d up(x, y, random.uniform(3.8, 5)), down(up.x, -up.y, up.z);
    EXPECT_NEAR(field.value(up), wide.smin(a.value(up), b.value(up)), 1e-12);
    EXPECT_NEAR(field.value(down), narrow.smin(a.value(down), b.value(down)), 1e-12);
    const double share = wide.share(a.value(up), b.value(up));
    EXPECT_NEAR(sample_materials(*field.node(), up).mix.weight("shale"), share, 1e-12);
  }
}

// The derivative of the blend by its radius is at most 1/4, and a smoothstep over 2 delta has the
// slope 0.75 / delta: the Lipschitz constant is 1 + 0.1875 dK / delta.
TEST(MaterialMeans, ABlendByMaterialKeepsItsLipschitzConstant) {
  for (const double delta : {0.1, 0.4, 1.0}) {
    const Field field = blended(2 * delta);
    const double bound = 1 + 0.1875 * 0.4 / delta;
    EXPECT_NEAR(field.lipschitz(), bound, 1e-9);
    EXPECT_LE(sampled_slope(field, 5, 0.05), bound + 1e-9);
  }
  const Field constant = blended(0.2, 0.5);  // Both pairs have the same radius.
  EXPECT_EQ(constant.lipschitz(), 1);
  EXPECT_LE(sampled_slope(constant, 5, 0.05), 1 + 1e-9);
  // Without a width the contact takes twice the difference of the radii.
  const Field wide = make("union_by_material", {{"a", as_value(of(orb(), "sand"))},
                                                {"b", as_value(two_rocks())},
                                                {"radii", List{pair("sand", "shale", 0.5)}}});
  EXPECT_LE(wide.lipschitz(), 1.19);
}

TEST(MaterialMeans, SurfacesAreContinuousAcrossContacts) {
  const Field rock = two_rocks(0);  // Even where the materials themselves are a step.
  Displacement options;
  options.amount = 0.3;
  options.by = softness(rock, 0.2);
  const Field surfaces[] = {displaced(rock, default_noise("fbm").value(), options), blended(0.4)};
  for (const Field& field : surfaces) {
    double jump = 0;
    for (double z = 3.5; z < 5; z += 0.1)
      for (double y = -0.3; y < 0.3; y += 1e-4)
        jump =
            std::max(jump, std::fabs(field.value({0.3, y + 1e-4, z}) - field.value({0.3, y, z})));
    EXPECT_LE(jump, 1e-3);
  }
}

TEST(MaterialMeans, FaultsNameTheRemedy) {
  const auto message = [](auto make_it) -> std::string {
    try {
      make_it();
    } catch (const Error& error) {
      return error.what() + error.hint();
    }
    return "no error";
  };
  EXPECT_NE(message([] { softness(orb(), 1); }).find("made_of"), std::string::npos);
  EXPECT_NE(message([] {
              make("union_by_material", {{"a", as_value(of(orb(), "clay"))},
                                         {"b", as_value(of(orb(), "sand"))},
                                         {"radii", List{pair("clay", "granite", 1)}}});
            }).find("neither solid is made of 'granite'"),
            std::string::npos);
  const Field row =
      make("repeat",
           {{"field", as_value(make("host_rock", {{"field", as_value(orb(0.5))},
                                                  {"of", "clay"},
                                                  {"bodies", list({of(orb(0.2), "sand")})}}))}});
  EXPECT_NE(message([&] { softness(row, 1); }).find("result of 'repeat'"), std::string::npos);
}

}  // namespace
}  // namespace vug::field
