// SPDX-License-Identifier: Apache-2.0
// Products of an L-system's drawing: a field, meshes, instances.
#include <gtest/gtest.h>
#include <vug/building/flat_scene.h>
#include <vug/loading/load.h>
#include <vug/mesh/topology.h>
#include <vug/shot/lsystem_plan.h>

#include <cmath>

namespace vug::loading {
namespace {

const std::string kTwig = R"(
grammar twig: lsystem {
  instances bud
  guides    drooping(length: 60cm, lean: 20deg, tip: 110deg)
  axiom guide(0) node F(20cm, 6mm) node [ &(50deg) F(15cm, 2mm) bud(3cm) ] F(40cm, 4mm) bud(2cm)
}
volume ball = level_set(sphere(radius: 0.5), voxel: 10cm)
mesh ball_mesh on ball {}
object thing on ball_mesh {}
)";

Loaded loaded(const std::string& text) { return load_text(text, "t.vug"); }

TEST(Plants, StemsAreAnOrdinarySolid) {
  const Loaded scene =
      loaded(kTwig +
             "field wood = stems(of: twig)\n"
             "volume rock = level_set(wood + box(size: (0.3, 0.1, 0.3)), voxel: 4mm)\n"
             "volume hole = level_set(box(size: (0.3, 0.3, 0.3)) - wood, voxel: 4mm)\n");
  ASSERT_EQ(scene.report(), "");
  const shot::VolumePlan& rock = *scene.shot.volumes.at(1);
  const lsystem::DrawingPtr drawing = scene.shot.lsystems.at(0)->drawing();
  for (const lsystem::Axis& axis : drawing->axes)
    EXPECT_LT(rock.field.value(lsystem::station_at(axis, 0.5 * axis.length()).position), 0);
  EXPECT_GT(scene.shot.volumes.at(2)->field.value({0, 0.01, 0}), 0);
  building::Builder builder(scene.shot);
  EXPECT_GT(builder.level_set(scene.shot.volumes.at(1)).statistics().active_voxels, 1000u);
}

TEST(Plants, AMeshOfStemsIsTheirSurface) {
  const Loaded scene = loaded(kTwig + "mesh bark { of stems(of: twig, wall: 20%) }\n");
  ASSERT_EQ(scene.report(), "");
  building::Builder builder(scene.shot);
  const mesh::MeshPtr mesh = builder.mesh(scene.shot.meshes.at(1));
  const mesh::Topology topology = mesh::inspect(*mesh);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.components, 4u);  // stem, branch, two chambers
  EXPECT_NE(mesh::find_attribute(*mesh, "below_node"), nullptr);
}

TEST(Plants, InstancesAreWhereTheTurtlePlacedThem) {
  const Loaded scene =
      loaded(kTwig + "place buds { of thing  at instances(of: twig, name: \"bud\", scale: 2) }\n");
  ASSERT_EQ(scene.report(), "");
  building::Builder builder(scene.shot);
  const building::FlatScene cast = building::flatten_scene(builder);
  ASSERT_EQ(cast.objects.size(), 2u);
  const lsystem::DrawingPtr drawing = scene.shot.lsystems.at(0)->drawing();
  for (size_t i = 0; i < 2; ++i) {
    const auto instance = cast.objects[i].instance->at(0);
    EXPECT_LT((Vec3d(instance.origin) - drawing->instances[i].position).length(), 1e-6);
  }
}

TEST(Plants, PolygonsMakeSheets) {
  const Loaded scene = loaded(
      "grammar square: lsystem { angle 90deg\n axiom { f(1) + f(1) + f(1) + f(1) } }\n"
      "mesh sheet { of square }\n");
  ASSERT_EQ(scene.report(), "");
  building::Builder builder(scene.shot);
  const mesh::MeshPtr mesh = builder.mesh(scene.shot.meshes.at(0));
  EXPECT_EQ(mesh->triangles.size(), 2u);
  EXPECT_NEAR(mesh->normals.at(0).z, 1, 1e-6);
}

TEST(Plants, QueriesFindRock) {
  // A climber that turns back before it enters the sphere.
  const Loaded scene = loaded(R"(
let ball = sphere(radius: 1m).translate((0, 3, 0))
grammar climber: lsystem {
  field ball
  steps 12
  axiom A ?D(9, 0, 0, 0)
  A > ?D(d, x, y, z) if d > 0.5 -> F(0.4, 1cm) A
  A > ?D(d, x, y, z) -> +(90deg) F(0.4, 1cm) Stop
}
mesh vine { of stems(of: climber) }
)");
  ASSERT_EQ(scene.report(), "");
  const lsystem::DrawingPtr drawing = scene.shot.lsystems.at(0)->drawing();
  const auto& stations = drawing->axes.at(0).stations;
  double highest = 0;
  for (const lsystem::Station& s : stations) highest = std::max(highest, s.position.y);
  EXPECT_NEAR(highest, 1.6, 1e-9);  // 0.4 m steps; at 1.6 m the sphere is 0.4 m away
  EXPECT_LT(stations.back().position.x, -0.3);
}

Loaded teaching_scene(const std::string& name, std::vector<scene::Override> overrides = {}) {
  LoadOptions options;
  options.overrides = std::move(overrides);
  options.include_folders = {VUG_DATA};
  return load(std::filesystem::path(VUG_DATA) / "scenes/lsystems" / name, options);
}

/// The distance of all shoots from rock, and the bending of their tips towards the light.
struct Climbed {
  double nearest = 1e9;
  double turned = 0;  ///< Mean of the cosine.
  size_t shoots = 0;
};

Climbed climbed(const std::string& light, const std::string& avoid) {
  const Loaded scene = teaching_scene("climbers.vug", {{"LIGHT", light}, {"AVOID", avoid}});
  EXPECT_TRUE(scene.usable()) << scene.report();
  const shot::LSystemPlan& shoots = *scene.shot.lsystems.at(0);
  Climbed out;
  for (const lsystem::Axis& axis : shoots.drawing()->axes) {
    for (const lsystem::Station& s : axis.stations)
      out.nearest = std::min(out.nearest, shoots.block.field->value(s.position));
    out.turned += axis.stations.back().frame.tangent.dot(Vec3d(0.48, 0.83, 0.28));
    ++out.shoots;
  }
  out.turned /= static_cast<double>(out.shoots);
  return out;
}

TEST(Plants, ClimbersKeepAwayFromRockAndReachForLight) {
  const Climbed both = climbed("1", "6"), blind = climbed("1", "0"), dark = climbed("0", "6");
  EXPECT_EQ(both.shoots, 9u);
  EXPECT_GT(both.nearest, 0.02);
  EXPECT_LT(blind.nearest, 0);  // without queries they grow into the rock
  EXPECT_GT(both.turned, 0.9);
  EXPECT_LT(dark.turned, 0.7);
}

TEST(Plants, FilamentsGrowWithoutPopping) {
  // From frame to frame cells grow by the law of their rules, without jumps at divisions.
  constexpr double kStep = 1.0 / 32;
  double before = 0;
  for (double time = 0; time <= 6; time += kStep) {
    const Loaded scene = teaching_scene("anabaena.vug", {{"TIME", std::to_string(time)}});
    ASSERT_TRUE(scene.usable()) << scene.report();
    double length = 0;
    for (const lsystem::Axis& axis : scene.shot.lsystems.at(0)->drawing()->axes)
      length += axis.length();
    if (before > 0) {
      EXPECT_GT(length, before);
      EXPECT_LT(length, before * std::pow(1.618, kStep) * (1 + 1e-3)) << time;
    }
    before = length;
  }
}

TEST(Plants, AnAnimationMayBeginEmpty) {
  const Loaded scene = loaded(R"(
grammar shoot: lsystem {
  time 0
  axiom A(0)
  A(t) after 9 -> A(0)
  interpret { A(t) -> F(t*1cm, 1cm) }
}
mesh bark { of stems(of: shoot) }
mesh leaves { of shoot }
object plant on bark {}
place plants { of leaves  at [(0, 0, 0), (1, 0, 0)] }
)");
  ASSERT_TRUE(scene.usable()) << scene.report();
  EXPECT_NE(scene.report().find("t.vug:8:16: warning: there are no stems"), std::string::npos)
      << scene.report();
  EXPECT_NE(scene.report().find("t.vug:9:18: warning: the L-system draws no polygons"),
            std::string::npos);
  building::Builder builder(scene.shot);
  EXPECT_TRUE(builder.mesh(scene.shot.meshes.at(0))->triangles.empty());
  EXPECT_EQ(building::flatten_scene(builder).objects.size(), 3u);
}

TEST(Plants, PolygonsDoNotCrossThemselves) {
  const auto report = [](const std::string& word) {
    return loaded("grammar g: lsystem {\n angle 90deg\n axiom " + word + "\n}\nmesh m1 { of g }\n")
        .report();
  };
  const std::string star = "{ F +(144deg) F +(144deg) F +(144deg) F +(144deg) F }";
  EXPECT_NE(report(star).find("t.vug:5:14: error: polygon 1 that the turtle draws crosses itself: "
                              "sides 1 and 3 at"),
            std::string::npos)
      << report(star);
  // Both lobes have the same size and opposite orientation: the total area is 0.
  EXPECT_NE(report("{ . f(1) +(135deg) f(1.4142135623730951) -(135deg) f(1) }").find("crosses"),
            std::string::npos);
  // Touching an edge, running back along it and passing over it are not crossings.
  EXPECT_EQ(report("{ . f(1) + f(1) + f(1) + f(1) }"), "");
  EXPECT_EQ(report("{ . f(2) + f(1) + f(1) - - f(1) - f(1) }").find("crosses"), std::string::npos);
  EXPECT_EQ(report("{ . f(2) + f(1) + f(1) &(90deg) f(1) ^(90deg) + f(2) + f(2) }").find("crosses"),
            std::string::npos);
}

TEST(Plants, CutsOfSolidStemsShowNoHollow) {
  const auto report = [](const std::string& more) {
    return loaded("grammar g: lsystem {\n axiom F(1, 0.1)\n}\nlet wood = stems(of: g" + more +
                  ")\n")
        .report();
  };
  EXPECT_NE(report(", open: true")
                .find("t.vug:4:12: error: 'open' applies to hollow stems; "
                      "they need a 'wall'"),
            std::string::npos)
      << report(", open: true");
  EXPECT_EQ(report(", open: true, wall: 20%"), "");
  EXPECT_EQ(report(", open: true, wall_least: 1cm"), "");
}

TEST(Plants, PartOfTheDrawingCanBeListed) {
  const std::string rest = "\n axiom a(1cm) b(2cm)\n}\n";
  for (const char* list : {"instances a, b", "instances [a, b]"}) {
    const Loaded scene = loaded(std::string("grammar g: lsystem {\n ") + list + rest);
    ASSERT_EQ(scene.report(), "");
    EXPECT_EQ(scene.shot.lsystems.at(0)->drawing()->instances.size(), 2u);
  }
  EXPECT_NE(loaded("grammar g: lsystem {\n instances a b" + rest)
                .report()
                .find("hint: separate the values of 'instances' by commas"),
            std::string::npos);
}

TEST(Plants, UnknownQueries) {
  const auto report = [](const std::string& block) {
    return loaded("grammar g: lsystem {\n" + block + "\n}\n").report();
  };
  EXPECT_NE(report(" axiom ?Z(1)").find("t.vug:2:8: error: unknown query '?Z'"), std::string::npos);
  EXPECT_NE(report(" axiom A\n A > ?Z(x) -> A").find("t.vug:3:6: error: unknown query '?Z'"),
            std::string::npos);
  const std::string nowhere = report(" axiom ?D(1, 0, 0, 0) ?D(1, 0, 0, 0)");
  EXPECT_EQ(nowhere.find("t.vug:2:8: warning: '?D' queries the distance to the 'field'"), 0u)
      << nowhere;
  EXPECT_EQ(nowhere.find("warning", 20), std::string::npos);
  EXPECT_EQ(report(" field sphere(1m)\n axiom ?D(1, 0, 0, 0)"), "");
}

TEST(Plants, WordsKeepWithinMemory) {
  LoadOptions options;
  options.max_memory = 1 << 20;
  const std::string text =
      "grammar g: lsystem {\n steps 20\n axiom A(1)\n A(x) -> A(x)A(x)\n}\n"
      "grammar h: lsystem {\n axiom A\n interpret {\n depth 20\n A -> AA\n }\n}\n";
  const Loaded scene = load_text(text, "t.vug", options);
  ASSERT_EQ(scene.report(), "");
  for (const shot::LSystemPtr& plan : scene.shot.lsystems) try {
      plan->drawing();
      FAIL() << plan->name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("the memory of 1 MiB"), std::string::npos)
          << error.what();
    }
}

TEST(Plants, FaultsAreReportedAtTheirLocation) {
  const auto report = [](const std::string& text) { return loaded(text).report(); };
  EXPECT_NE(report(kTwig + "mesh no { of sphere(1m) }\n").find("does not consist of stems"),
            std::string::npos);
  EXPECT_NE(report(kTwig + "mesh no { of twig }\n").find("draws no polygons"), std::string::npos);
  EXPECT_NE(report(kTwig + "place no { of thing  at instances(of: twig, name: \"bug\") }\n")
                .find("places no instances 'bug'"),
            std::string::npos);
  EXPECT_NE(report("grammar g: lsystem { angel 3deg\n axiom F }\n").find("angle"),
            std::string::npos);
  EXPECT_NE(report("grammar g: lsystem { step -1m\n axiom F }\n"), "");
  EXPECT_NE(report("grammar g: lsystem { guides 3\n axiom F }\n"), "");
  EXPECT_NE(report("grammar g: lsystem { axiom F ] }\nfield s = stems(of: g)\n"), "");
  EXPECT_NE(report("grammar g: lsystem { axiom guide(0) F }\nfield s = stems(of: g)\n")
                .find("no guides are defined"),
            std::string::npos);
  EXPECT_NE(report("grammar g: lsystem { axiom F(log(0 - 1)) }\nfield s = stems(of: g)\n"), "");
  EXPECT_NE(report(kTwig + "field s = stems(of: twig, groove: 90%)\n"), "");
  EXPECT_NE(report(kTwig + "field s = stems(of: twig, from: 30cm, to: 20cm)\n").find("'to'"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::loading
