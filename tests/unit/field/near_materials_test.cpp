// SPDX-License-Identifier: Apache-2.0
// Materials of many points have the bits of those of single points, through every operator that
// evaluates them together, and most of them need no evaluation of their own.
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/boolean.h>
#include <vug/field/grown_material.h>
#include <vug/field/material_source.h>
#include <vug/field/near_materials.h>

#include "rocks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::field {
namespace {

Field rough(const Field& field) {
  return make("displace", {{"field", as_value(field)}, {"amount", 0.1}});
}
/// Rock and clay that blend, below a layer of calcite on a part of the surface.
Field cave() {
  const Field ground =
      unite({of(rough(shifted(cube(), {0, -4, 0})), "limestone"), of(rough(orb(1.5)), "clay")},
            {Profile::smooth, 0.3});
  const Field thick = unite({ground, shifted(orb(0.5), {2, 0, 2})});
  return grown_on(ground, thick, std::make_shared<RockMaterial>(RockMaterial{"calcite", 0}));
}
/// Solids of three materials in a box, with a blend.
Field grains(const Blend& blend) {
  std::vector<Field> out;
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 60; ++i) {
    const double x = random.uniform(-3, 3), y = random.uniform(-1, 1);
    const Field grain = shifted(orb(0.4), {x, y, random.uniform(-3, 3)});
    out.push_back(i % 9 == 4 ? grain : of(grain, std::string(1, static_cast<char>('a' + i % 3))));
  }
  return unite(out, blend);
}
Field cut(const Field& air) { return subtract(two_rocks(), {air, shifted(orb(0.5), {1, 1, 1})}); }

std::vector<std::pair<std::string, Field>> fields() {
  const Field coated = make("coat", {{"field", as_value(orb())}, {"of", "clay"}});
  return {{"cave", cave()},
          {"grains", grains({})},
          {"blended grains", grains({Profile::round, 0.2})},
          {"contact", two_rocks(0.05)},
          {"no contact", two_rocks(0)},
          {"cut", cut(orb())},
          {"coated cut", cut(coated)},
          {"complement", complement(of(orb(), "marl"))},
          {"intersection", intersect({two_rocks(), of(orb(2), "marl")}, {Profile::chamfer, 0.1})},
          {"warped", make("warp", {{"field", as_value(cave())}, {"amount", 0.4}})},
          {"far", shifted(cave(), {3000, -500, 700})},
          {"repeated", make("repeat", {{"field", as_value(of(orb(0.5), "chert"))}})},
          {"morphed", unite({morph(of(orb(), "sand"), of(cube(), "clay"), 0.3), two_rocks()})},
          {"without materials", orb()}};
}

/// A lattice around a centre, and points far from each other.
std::vector<Vec3f> points_near(const Vec3d& centre) {
  std::vector<Vec3f> out;
  for (int x = -20; x <= 20; ++x)
    for (int y = -12; y <= 12; ++y)
      for (int z = -20; z <= 20; ++z) out.emplace_back(centre + 0.15 * Vec3d(x, y, z));
  RandomStream random(RandomKey(7));
  for (int i = 0; i < 500; ++i) {
    const double x = random.uniform(-40, 40), y = random.uniform(-40, 40);
    out.emplace_back(centre + Vec3d(x, y, random.uniform(-40, 40)));
  }
  return out;
}

TEST(NearMaterials, HaveTheBitsOfSinglePoints) {
  for (const auto& each : fields()) {
    const std::string& name = each.first;
    const Field& field = each.second;
    const std::vector<Vec3f> points =
        points_near(name == "far" ? Vec3d(3000, -500, 700) : Vec3d(0.0));
    for (const int threads : {1, 7}) {
      const std::vector<MaterialMix> all =
          with_threads(threads, [&] { return materials_at(field, points); });
      for (size_t i = 0; i < points.size(); ++i) {
        const MaterialMix one = sample_materials(*field.node(), Vec3d(points[i])).mix;
        ASSERT_EQ(one.parts().size(), all[i].parts().size()) << name << " " << points[i];
        for (size_t k = 0; k < one.parts().size(); ++k) {
          ASSERT_EQ(one.parts()[k].material->name, all[i].parts()[k].material->name) << name;
          ASSERT_EQ(one.parts()[k].weight, all[i].parts()[k].weight) << name << " " << points[i];
        }
      }
    }
  }
}

// Without known mixes nothing would be gained. Most of the blended grains blend.
TEST(NearMaterials, AreKnownAwayFromContacts) {
  for (const auto& [name, field] : fields()) {
    if (name == "far" || name == "repeated" || name == "morphed" || name == "coated cut" ||
        name == "blended grains")
      continue;
    std::vector<Vec3d> near;
    for (int i = 0; i < 512; ++i)
      near.push_back(Vec3d(0.31, 0.27, 0.53) + 0.12 * Vec3d(i / 64, i / 8 % 8, i % 8));
    const NearMixes mixes = mixes_near(*field.node(), NearPoints(near));
    EXPECT_GT(std::count(mixes.known.begin(), mixes.known.end(), 1), 400) << name;
  }
}

// Bounds of the errors decide which mixes are known.
TEST(NearMaterials, ValuesAreWithinTheirErrors) {
  for (const auto& [name, field] : fields()) {
    std::vector<Vec3d> near;
    for (int i = 0; i < 512; ++i)
      near.push_back(Vec3d(-0.6, -0.5, -0.4) + 0.15 * Vec3d(i / 64, i / 8 % 8, i % 8));
    const double limit = 0.3;
    const NearPoints points(near);
    const NearValues values = values_near(*field.node(), points, limit);
    for (size_t i = 0; i < near.size(); ++i) {
      const double value = field.value(near[i]);
      if (values.values.empty()) {
        ASSERT_GT(value, limit) << name;
      } else if (value <= limit) {
        ASSERT_NEAR(values.values[i], value, values.error) << name;
      } else {
        ASSERT_GT(values.values[i], limit - values.error) << name;
      }
    }
  }
}

}  // namespace
}  // namespace vug::field
