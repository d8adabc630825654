// SPDX-License-Identifier: Apache-2.0
// Named drips of scenes, their edits, points and fields.
#include <gtest/gtest.h>
#include <vug/base/rng.h>
#include <vug/field/material_source.h>
#include <vug/loading/load.h>
#include <vug/shot/drips_plan.h>
#include <vug/shot/queries.h>

#include <cmath>

namespace vug::loading {
namespace {

std::string drips_with(const std::string& more) {
  return "let room = complement(box(size: (6, 3, 6)))\n"
         "drips water = seepage(room, from: (-3, -2, -3), to: (3, 2, 3), spacing: 40cm" +
         more + ")\n";
}

TEST(DripsDeclaration, GivesPointsAndFields) {
  const Loaded scene = load_text(
      drips_with(", budget: 12") +
          "light tip[p in drip_points(of: water, only: tips)] = sphere(center: p, radius: 1cm)\n"
          "light low[p in drip_points(of: water, up: 10cm)] = sphere(center: p, radius: 1cm)\n"
          "field all = speleothems(of: water)\n"
          "field films = water_paths(of: water, only: films, radius: 2cm)\n",
      "t.vug", {});
  ASSERT_EQ(scene.report(), "");
  const shot::DripsPlan& plan = *shot::find_drips(scene.shot, "").drips;
  size_t landings = 0, hanging = 0;
  for (const drips::Node& node : plan.graph().nodes)
    landings += node.kind == drips::NodeKind::landing;
  for (const drips::Form& form : plan.grown().forms)
    hanging += form.kind == drips::FormKind::straw || form.kind == drips::FormKind::stalactite;
  EXPECT_GT(landings, 5u);
  EXPECT_LE(landings, 12u);
  EXPECT_GT(hanging, 0u);
  EXPECT_EQ(scene.shot.lights.size(), hanging + landings);
}

TEST(DripsDeclaration, ItsSpeleothemsAreSolidAtTheirDrips) {
  const Loaded scene = load_text(
      drips_with(", density: 0, stalagmites: 1, broken: 0, edits: [add_drip(at: (0.5, 0, 0), "
                 "interval: 30, "
                 "age: 4000)]") +
          "volume rock = level_set(speleothems(of: water), voxel: 5cm, from: (-4, -2, -4), to: (4, "
          "2, 4))\n"
          "volume films = level_set(water_paths(of: water, only: falls, radius: 2cm), voxel: "
          "1cm)\n",
      "t.vug", {});
  ASSERT_EQ(scene.report(), "");
  const shot::DripsPlan& plan = *scene.shot.drips.at(0).drips;
  const std::vector<drips::Form> forms = plan.grown().forms;
  ASSERT_EQ(forms.size(), 2u);
  const auto value = [&](size_t volume, const Vec3d& p) {
    return scene.shot.volumes.at(volume)->field.value(p);
  };
  for (const drips::Form& form : forms) {
    EXPECT_EQ(form.drip, -1);
    EXPECT_LT(value(0, 0.5 * (form.top + form.bottom)), 0) << "the stone is solid";
  }
  const Vec3d tip = forms[0].bottom, apex = forms[1].top, between = 0.5 * (tip + apex);
  EXPECT_GT(value(0, between), 0) << "air below the tip";
  EXPECT_NEAR(value(1, between), -0.02, 1e-4) << "the fall is the middle of its tube";
}

TEST(DripsDeclaration, GivesSolidsAndRockApart) {
  const std::string region = "voxel: 10cm, from: (-4, -2, -4), to: (4, 2, 4))\n";
  const Loaded scene = load_text(
      drips_with(", density: 0.3") + "volume all = level_set(speleothems(of: water, root: 5cm), " +
          region + "volume rock = level_set(speleothems(of: water, part: rock), " + region +
          "volume solids = level_set(speleothems(of: water, part: solids), voxel: 3cm)\n",
      "t.vug", {});
  ASSERT_EQ(scene.report(), "");
  const auto value = [&](size_t volume, const Vec3d& p) {
    return scene.shot.volumes.at(volume)->field.value(p);
  };
  RandomStream random(RandomKey(5));
  int in_solids = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d p(random.uniform(-3, 3), random.uniform(-2, 2), random.uniform(-3, 3));
    const double rock = value(1, p), solids = value(2, p);
    in_solids += solids < 0 && rock > 0;
    ASSERT_LE(value(0, p), std::min(rock, solids)) << p;
    ASSERT_GE(value(0, p), std::min(rock, solids) - 0.05 / 4) << p;  // The depth of the blend.
  }
  EXPECT_GT(in_solids, 4);
}

TEST(DripsDeclaration, GivesLabelsWithTheNumbersOfDrips) {
  const Loaded scene = load_text(
      drips_with(", density: 0, stalagmites: 1, broken: 0, edits: [for x in [-2, -1, 0, 1, 2]: "
                 "add_drip(at: (x, 0, 0), interval: 600, age: 4000)]") +
          "volume rock = level_set(speleothems(of: water), voxel: 5cm, from: (-4, -2, -4), to: (4, "
          "2, 4))\n"
          "mesh all on rock { labels form_labels(of: water) }\n"
          "mesh few on rock { labels form_labels(of: water, most: 0) }\n",
      "t.vug", {});
  ASSERT_EQ(scene.report(), "");
  const auto nearest = [&](const std::string& mesh, const Vec3d& p) {
    const shot::MeshPtr plan = shot::find_mesh(scene.shot, mesh);
    std::string name;
    double least = kInfinity;
    for (const shot::SurfaceLabel& label : plan->labels)
      if (const double value = label.field.value(p); value < least)
        least = value, name = label.name;
    return name;
  };
  const auto number = [](int64_t drip) { return "_added" + std::to_string(-drip); };
  const drips::Dripstone& grown = scene.shot.drips.at(0).drips->grown();
  ASSERT_GE(grown.forms.size(), 5u);
  for (const drips::Form& form : grown.forms) {
    const Vec3d middle = 0.5 * (form.top + form.bottom);
    const std::string kind = drips::kind_name(form.kind);
    EXPECT_EQ(nearest("all", middle), kind + number(form.drip));
    EXPECT_EQ(nearest("few", middle), kind);
  }
  EXPECT_EQ(nearest("all", Vec3d(3, 0, 2)), "rock") << "a wall that no water has reached";
  // Around the feet of the stalagmites, the surface is that of their skirts.
  int skirts = 0;
  for (const field::Deposit& layer : grown.layers)
    for (double part = 0.5; part < 1; part += 0.05) {
      const double share = 1 - part * part;
      const Vec3d p =
          layer.from + Vec3d(part * layer.half_width_from, share * share * layer.thickness_from, 0);
      const std::string name = nearest("all", p);
      skirts += name == "flowstone" + number(layer.drip);
      EXPECT_TRUE(name.ends_with(number(layer.drip))) << name;
    }
  EXPECT_GT(skirts, 5);
}

// A film of three times the thickness carries 27 times the water.
TEST(DripsDeclaration, WaysWidenWithTheirDischarge) {
  const Loaded scene = load_text(
      drips_with(", density: 100%") +
          "volume even = level_set(water_paths(of: water, radius: 1mm), voxel: 1cm)\n"
          "volume wide = level_set(water_paths(of: water, radius: 1mm, by_discharge: 1/3), voxel: "
          "1cm)\n",
      "t.vug", {});
  ASSERT_EQ(scene.report(), "");
  const drips::Graph& graph = scene.shot.drips.at(0).drips->graph();
  const field::Field &even = scene.shot.volumes.at(0)->field,
                     &wide = scene.shot.volumes.at(1)->field;
  double least = 1, most = 0;
  for (const drips::Edge& edge : graph.edges) {
    const Vec3d middle = 0.5 * (edge.path[0] + edge.path[1]);
    if (even.value(middle) < -0.00101) continue;  // Another way crosses it.
    const double drops = 60 * edge.water.discharge / graph.drop;
    const double radius = 0.001 * std::min(4.0, std::cbrt(drops));
    // Classes differ by the fourth root of 2, and wider ways may cross.
    EXPECT_LE(wide.value(middle), -radius / std::pow(2.0, 0.25) + 1e-6);
    EXPECT_GE(wide.value(middle), -0.00401);
    least = std::min(least, -wide.value(middle));
    most = std::max(most, -wide.value(middle));
  }
  EXPECT_GT(most, 1.5 * least);
}

TEST(DripsDeclaration, AShareOfTheWaysFollowsTheWaterOfItsDrips) {
  const Loaded scene = load_text(
      drips_with(", density: 100%") +
          "volume some = level_set(water_paths(of: water, share: 30%, radius: 1mm), voxel: 1cm)\n"
          "volume none = level_set(water_paths(of: water, share: 0%, radius: 1mm), voxel: 1cm)\n",
      "t.vug", {});
  ASSERT_EQ(scene.report(), "");
  const drips::Graph& graph = scene.shot.drips.at(0).drips->graph();
  const field::Field &some = scene.shot.volumes.at(0)->field,
                     &none = scene.shot.volumes.at(1)->field;
  std::vector<bool> reached(graph.nodes.size());
  size_t shown = 0, seeps = 0;
  for (const drips::Edge& edge : graph.edges) {
    const auto on_path = [&](const field::Field& field) {
      return field.value(0.5 * (edge.path[0] + edge.path[1])) < 1e-4;
    };
    EXPECT_FALSE(on_path(none));
    if (graph.nodes[static_cast<size_t>(edge.from)].kind == drips::NodeKind::seep) {
      ++seeps;
      shown += on_path(some);
    }
    if (on_path(some)) reached[static_cast<size_t>(edge.to)] = true;
    if (reached[static_cast<size_t>(edge.from)] && edge.path[0] != edge.path[1]) {
      EXPECT_TRUE(on_path(some)) << "water takes its stain along";
    }
  }
  EXPECT_GT(shown, seeps / 5);
  EXPECT_LT(shown, seeps / 2);
}

TEST(DripsDeclaration, WhatHasGrownHasAMaterialOfItsOwn) {
  const auto scene_with = [](const std::string& rock) {
    return load_text(
        "let room = " + rock +
            "\ndrips water = seepage(room, from: (-3, -2, -3), to: (3, 2, 3), density: 0,\n"
            "  stalagmites: 1, broken: 0, edits: [add_drip(at: (0.5, 0, 0), age: 4000)])\n"
            "field all = speleothems(of: water, material: \"calcite\")\n"
            "volume v = level_set(all, voxel: 5cm, from: (-4, -2, -4), to: (4, 2, 4))\n",
        "t.vug", {});
  };
  const std::string bare = "complement(box(size: (6, 3, 6)))";
  const Loaded scene = scene_with("made_of(" + bare + ", of: \"limestone\")");
  ASSERT_EQ(scene.report(), "");
  const field::Field& all = scene.shot.volumes.at(0)->field;
  const auto weight = [&](const Vec3d& p) {
    return field::sample_materials(*all.node(), p).mix.weight("calcite");
  };
  for (const drips::Form& form : scene.shot.drips.at(0).drips->grown().forms)
    EXPECT_GT(weight(0.5 * (form.top + form.bottom)), 0.99);
  EXPECT_LT(weight(Vec3d(3, 0, 2)), 0.01) << "a wall that no water has reached";
  EXPECT_LT(weight(Vec3d(0.5, 1.9, 0.3)), 0.01) << "inside the rock";
  EXPECT_NE(scene_with(bare).report().find("the rock has no material"), std::string::npos);
}

TEST(DripsDeclaration, ReportsFaultsAtTheCall) {
  const auto report = [](const std::string& more) {
    return load_text(drips_with(", " + more), "t.vug", {}).report();
  };
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const std::string outside = report("edits: [add_drip(at: (0, 9, 0))]");
  has(outside, "t.vug:2:87");
  has(outside, "a drip at (0, 9, 0) is outside the box of the drips");
  has(report("edits: [add_drip(at: (0, 0, 0), age: 20000)]"), "the oldest ones are 10000");
  const std::string open =
      load_text(
          "let room = complement(box(size: (6, 3, 6)))\n"
          "drips water = seepage(room, from: (-3, -2, -3), to: (3, 1, 3),\n"
          "  edits: [add_drip(at: (1, 0.9, 0)), move_drip(drip: 1, to: (0, 0, 0))])\n",
          "t.vug", {})
          .report();
  has(open, "t.vug:3:");
  has(open, "the drip at (0, 0, 0) has no roof above it");
  has(open, "ends at a height of 1 m");
  has(report("edits: [add_drip(at: (0, 0, 0), interval: 20s)]"), "without a unit");
  has(load_text("drips water = seepage(sphere(1m), from: (-3, 50, -3), to: (3, 2, 3))\n", "t.vug",
                {})
          .report(),
      "'from' must be less than 'to' in x, y and z, but in y it is 50m and 'to' is 2m");
  has(report("edits: [remove_drip(drip: 3), move_drip(drip: 3, to: (0, 0, 0))]"),
      "drip 3 is moved or removed twice");
  has(load_text("volume v = level_set(speleothems(of: 3), voxel: 5cm)\n", "t.vug", {}).report(),
      "'of' expects drips, not a number");
  has(load_text("volume v = level_set(speleothems(of: wate), voxel: 5cm)\n" + drips_with(""),
                "t.vug", {})
          .report(),
      "did you mean 'water'?");
}

TEST(DripsDeclaration, IsFoundByName) {
  const Loaded scene = load_text(drips_with(""), "t.vug", {});
  EXPECT_EQ(shot::find_drips(scene.shot, "water").name, "water");
  EXPECT_THROW(shot::find_drips(scene.shot, "wine"), Error);
}

}  // namespace
}  // namespace vug::loading
