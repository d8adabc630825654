// SPDX-License-Identifier: Apache-2.0
// Materials of fields: weights at contacts, through the field algebra, and their sums.
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/material_source.h>
#include <vug/field/registry.h>

#include "rocks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

MaterialMix mix(const Field& field, const Vec3d& p) {
  return sample_materials(*field.node(), p).mix;
}
double weight(const Field& field, const std::string& material, const Vec3d& p) {
  return mix(field, p).weight(material);
}
double sum(const MaterialMix& mix) {
  double total = 0;
  for (const MaterialMix::Part& part : mix.parts()) total += part.weight;
  return total;
}
Vec3d random_point(RandomStream& random, double reach) {
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}

// Without a blend the nearer solid has all the weight.
TEST(Materials, ASharpUnionHasTheMaterialOfTheNearerSolid) {
  const Field both = unite({of(orb(), "limestone"), of(shifted(orb(), {1.5, 0, 0}), "calcite")});
  RandomStream random(RandomKey(1));
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 3);
    const bool left = p.x < 0.75;
    EXPECT_EQ(weight(both, "limestone", p), left ? 1 : 0) << p;
    EXPECT_EQ(weight(both, "calcite", p), left ? 0 : 1) << p;
  }
}

// The mix factor of quilez2013smin: m = h^2 / 2 on the farther side, h = max(0, 1 - |a - b| / k).
TEST(Materials, ABlendMixesAsItsDistances) {
  const double k = 0.4;
  const Field a = orb(), b = shifted(orb(), {1.5, 0, 0});
  const Blend blend{Profile::smooth, k};
  const Field either = unite({of(a, "limestone"), of(b, "calcite")}, blend);
  const Field common = intersect({of(a, "limestone"), of(b, "calcite")}, blend);
  EXPECT_EQ(weight(either, "calcite", {0.75, 0.3, 0}), 0.5);
  EXPECT_EQ(weight(common, "calcite", {0.75, 0.3, 0}), 0.5);
  RandomStream random(RandomKey(2));
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 2);
    const double x = a.value(p), y = b.value(p), h = std::max(0.0, 1 - std::fabs(x - y) / k);
    const double m = 0.5 * h * h;
    EXPECT_NEAR(weight(either, "calcite", p), x <= y ? m : 1 - m, 1e-12);
    EXPECT_NEAR(weight(common, "calcite", p), x >= y ? m : 1 - m, 1e-12);
  }
}

TEST(Materials, ContactsChangeOverTheirWidthOnly) {
  const Field rock = two_rocks(0.1);
  for (double y = -1; y <= 1; y += 0.01) {
    const double w = weight(rock, "limestone", {0.3, y, -0.2});
    if (std::fabs(y) > 0.05) {
      EXPECT_NEAR(w, y < 0 ? 1 : 0, 1e-3) << y;
    }
    const double t = std::min(1.0, std::max(0.0, 0.5 - y / 0.1));
    EXPECT_NEAR(w, t * t * (3 - 2 * t), 1e-12) << y;
    EXPECT_NEAR(w + weight(rock, "shale", {0.3, y, -0.2}), 1, 1e-12);
  }
  EXPECT_EQ(weight(two_rocks(0), "limestone", {0, -1e-9, 0}), 1);
  EXPECT_EQ(weight(two_rocks(0), "limestone", {0, 1e-9, 0}), 0);
}

/// Every operator, deformer and detail over six materials; more than four meet near the origin.
Field many_materials() {
  std::vector<Field> grains;
  for (const char* name : {"chert", "clay", "dolomite", "gypsum", "marl"})
    grains.push_back(
        of(shifted(orb(0.8), Vec3d(0.2 * static_cast<double>(grains.size()), 0, 0)), name));
  const Field host = make("host_rock", {{"field", as_value(cube())},
                                        {"of", "limestone"},
                                        {"bodies", list(grains)},
                                        {"contact", 1.5}});
  const Field twisted =
      make("twist", {{"field", as_value(host)}, {"rate", Number{0.3, Dimension::per_length}}});
  const Field cut = subtract(make("displace", {{"field", as_value(twisted)}}),
                             {make("coat", {{"field", as_value(shifted(orb(), {1, 1, 0}))},
                                            {"of", "calcite"},
                                            {"thickness", 0.2}})});
  return unite({cut, morph(of(orb(0.5), "sand"), of(orb(0.9), "clay"), 0.3)},
               {Profile::smooth, 0.5});
}

TEST(Materials, TheSumIsOneEverywhere) {
  const Field field = many_materials();
  RandomStream random(RandomKey(3));
  bool full = false;
  for (int i = 0; i < 100000; ++i) {
    const MaterialMix here = mix(field, random_point(random, 4));
    full = full || here.parts().size() == MaterialMix::kMost;
    ASSERT_NEAR(sum(here), 1, 1e-6);
    for (size_t k = 0; k < here.parts().size(); ++k) {
      ASSERT_GT(here.parts()[k].weight, 0);
      if (k > 0) {
        ASSERT_LT(here.parts()[k - 1].material->name, here.parts()[k].material->name);
      }
    }
  }
  EXPECT_TRUE(full);
}

TEST(Materials, OfMoreThanFourTheLargestRemain) {
  const RockMaterial names[] = {{"a", 0}, {"b", 0}, {"c", 0}, {"d", 0}, {"e", 0}};
  MaterialMix all(names[0]);
  // Weights before the fifth: a .25, b .25, c .25, d .25; e takes 0.5, each other has 0.125.
  for (int i = 1; i < 4; ++i) all = mixed(all, MaterialMix(names[i]), 1.0 / (i + 1));
  all = mixed(all, MaterialMix(names[4]), 0.5);
  ASSERT_EQ(all.parts().size(), 4u);
  EXPECT_NEAR(all.weight("e"), 0.5 / 0.875, 1e-12);
  EXPECT_NEAR(all.weight("a"), 0.125 / 0.875, 1e-12);
  EXPECT_EQ(all.weight("d"), 0);  // Of equal weights the first names remain.
  EXPECT_NEAR(sum(all), 1, 1e-12);
  EXPECT_EQ(all.dominant()->name, "e");
}

TEST(Materials, ACutExposesTheRockUnlessItHasACoat) {
  const Field rock = two_rocks();
  const Field air = of(orb(), "limestone");
  const Field bare = subtract(rock, {air});
  const Field coated = subtract(
      rock, {make("coat", {{"field", as_value(air)}, {"of", "calcite"}, {"thickness", 0.02}})});
  EXPECT_EQ(weight(bare, "shale", {0, 1, 0}), 1);
  EXPECT_EQ(weight(bare, "limestone", {0, -1, 0}), 1);
  EXPECT_EQ(weight(coated, "calcite", {0, 1, 0}), 1);
  EXPECT_NEAR(weight(coated, "calcite", {0, 1.02, 0}), 0.5, 1e-12);
  EXPECT_EQ(weight(coated, "shale", {0, 1.04, 0}), 1);
  // The rock around the air is the complement of the coated air.
  EXPECT_EQ(weight(complement(make("coat", {{"field", as_value(air)}, {"of", "clay"}})), "clay",
                   {1, 0, 0}),
            1);
}

TEST(Materials, MovedSolidsKeepTheirMaterials) {
  const Field rock = two_rocks();
  const Transform map = Transform::translation({3, 1, 0}) * Transform::rotation({0, 0, 1}, 1);
  const Field moved = transformed(rock, map);
  const Field named =
      make("offset", {{"field", as_value(make("displace", {{"field", as_value(rock)}}))},
                      {"by", Number{0.3, Dimension::length}}});
  RandomStream random(RandomKey(4));
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 1);
    EXPECT_NEAR(weight(moved, "limestone", map.point(p)), weight(rock, "limestone", p), 1e-9);
    EXPECT_EQ(weight(named, "limestone", p), weight(rock, "limestone", p));
  }
  const Field row = make("repeat", {{"field", as_value(of(orb(0.5), "chert"))}});
  EXPECT_EQ(weight(row, "chert", {4.2, 0, 2}), 1);
}

TEST(Materials, APartWithoutAMaterialTakesThatOfTheOther) {
  const Field joined = unite({orb(), of(shifted(orb(), {4, 0, 0}), "limestone")});
  EXPECT_EQ(weight(joined, "limestone", {-1, 0, 0}), 1);
  EXPECT_TRUE(mix(orb(), {0, 0, 0}).empty());
  EXPECT_TRUE(materials_of(orb()).empty());
}

// Far operands are skipped by their boxes, which must not change anything.
TEST(Materials, SkippedOperandsDoNotMatter) {
  std::vector<Field> grains;
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 60; ++i) {
    const std::string material(1, static_cast<char>('a' + i % 7));
    grains.push_back(of(shifted(orb(0.4), random_point(random, 2)), material));
  }
  const Blend blend{Profile::round, 0.2};
  const Field all = unite(grains, blend);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random_point(random, 2);
    double value = grains[0].value(p);
    MaterialMix want = mix(grains[0], p);
    for (size_t k = 1; k < grains.size(); ++k) {
      const double next = grains[k].value(p);
      want = mixed(want, mix(grains[k], p), blend.share(value, next));
      value = blend.smin(value, next);
    }
    const MaterialSample got = sample_materials(*all.node(), p);
    ASSERT_EQ(got.value, all.value(p));
    ASSERT_EQ(got.mix.parts().size(), want.parts().size());
    for (const MaterialMix::Part& part : want.parts())
      ASSERT_EQ(got.mix.weight(part.material->name), part.weight);
  }
}

TEST(Materials, TheListOfMaterialsIsThatOfTheField) {
  std::vector<std::string> names;
  for (const RockMaterialPtr& each : materials_of(many_materials())) names.push_back(each->name);
  EXPECT_EQ(names, (std::vector<std::string>{"calcite", "chert", "clay", "dolomite", "gypsum",
                                             "limestone", "marl", "sand"}));
  EXPECT_EQ(materials_of(of(two_rocks(), "clay")).size(), 1u);  // Replaces those below it.
}

TEST(Materials, BatchesAreTheSameForAnyNumberOfThreads) {
  const Field field = many_materials();
  std::vector<Vec3f> points;
  RandomStream random(RandomKey(6));
  for (int i = 0; i < 3000; ++i) points.push_back(Vec3f(random_point(random, 4)));
  const std::vector<MaterialMix> batch = materials_at(field, points);
  for (size_t i = 0; i < points.size(); ++i) {
    const MaterialMix one = mix(field, Vec3d(points[i]));
    ASSERT_EQ(one.parts().size(), batch[i].parts().size());
    for (size_t k = 0; k < one.parts().size(); ++k)
      ASSERT_EQ(one.parts()[k].weight, batch[i].parts()[k].weight);
  }
}

TEST(Materials, FaultsNameTheRemedy) {
  const auto message = [](const std::string& kind, const NamedValues& params) -> std::string {
    try {
      make(kind, params);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(message("made_of", {{"field", as_value(orb())}, {"of", "hard rock"}})
                .find("letters, digits and '_'"),
            std::string::npos);
  EXPECT_NE(message("host_rock",
                    {{"field", as_value(orb())}, {"of", "limestone"}, {"bodies", list({orb()})}})
                .find("made_of(BODY"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::field
