// SPDX-License-Identifier: Apache-2.0
// Networks of scenes and the points on them.
#include <gtest/gtest.h>
#include <vug/loading/item_clauses.h>
#include <vug/loading/load.h>
#include <vug/network/metrics.h>
#include <vug/shot/queries.h>

namespace vug::loading {
namespace {

const std::string kPlan =
    "network plan = graph(names: [\"mouth\", \"fork\", \"hall\", \"sump\"],\n"
    "  at: [(0, 0, 0), (8, -1, 2), (15, -2, 0), (14, -4, 9)],\n"
    "  paths: [\"mouth fork hall\", \"fork sump\"])\n";

Loaded scene_of(const std::string& text) { return load_text(kPlan + text, "t.vug", {}); }

TEST(NetworkDeclaration, StationsArePointsOfCamerasAndLights) {
  const Loaded scene = scene_of(
      "camera main { eye station(of: plan, name: \"mouth\", up: 1.6m) + (0, 0, 1)\n"
      "  target station(of: plan, name: \"fork\") }\n"
      "light lamp[p in stations(of: plan, only: ends, up: 2m)] = sphere(center: p, radius: 2cm)\n"
      "light row[p in along(of: plan, spacing: 2m)] = sphere(center: p, radius: 2cm)\n");
  ASSERT_EQ(scene.report(), "");
  // Three ends; branches of 8.3, 7.3 and 9.7 m.
  ASSERT_EQ(scene.shot.lights.size(), 3u + 4u + 4u + 5u);
  EXPECT_EQ(scene.shot.lights[2].first, "lamp[2]");
}

TEST(NetworkDeclaration, WarnsAboutLongRowsOfLights) {
  const auto report = [](const std::string& spacing) {
    return scene_of("light row[p in along(of: plan, spacing: " + spacing +
                    ")] = sphere(center: p, radius: 2cm)\n")
        .report();
  };
  EXPECT_EQ(report("20cm"), "");  // About 127 lights.
  EXPECT_NE(report("10cm").find("t.vug:4:7: warning: 'row' is a row of 254 lights"),
            std::string::npos)
      << report("10cm");
  EXPECT_NE(report("10cm").find("larger 'spacing'"), std::string::npos);
  EXPECT_NE(scene_of("let points = along(of: plan, spacing: 10cm)\n"
                     "light row[p in points] = sphere(center: p, radius: 2cm)\n")
                .report()
                .find("a row of 254 lights"),
            std::string::npos);
}

TEST(NetworkDeclaration, ReportsFaultsOfGraphs) {
  const auto problem = [](const std::string& arguments) {
    return load_text("network plan = graph(" + arguments + ")\n", "t.vug", {}).report();
  };
  EXPECT_NE(problem("names: [\"a\", \"b\"], at: [(0, 0, 0)], paths: [\"a b\"]")
                .find("'names' has 2 elements, but 'at' has 1; they need one each"),
            std::string::npos);
  EXPECT_NE(problem("names: [\"a\", \"b\"], at: [(0, 0, 0), (1, 0, 0)], paths: [\"a c\"]")
                .find("the path 'a c' contains the unknown station 'c'"),
            std::string::npos);
  EXPECT_NE(problem("names: [\"a\", \"a\"], at: [(0, 0, 0), (1, 0, 0)], paths: [\"a a\"]")
                .find("two stations are named 'a'"),
            std::string::npos);
  EXPECT_NE(problem("names: [\"a\", \"b\"], at: [(1, 0, 0), (1, 0, 0)], paths: [\"a b\"]")
                .find("joins the stations 'a' and 'b', which are at the same place"),
            std::string::npos);
  EXPECT_NE(problem("names: [\"a\", \"b\"], at: [(0, 0, 0), (1e300, 0, 0)], paths: [\"a b\"]")
                .find("the station 'b' is at (1e+300, 0, 0)"),
            std::string::npos);
  EXPECT_NE(problem("names: [\"a\", \"b\"], at: [(0, 0, 0), (1, 0, 0)], paths: [\"a\"]")
                .find("the path 'a' needs at least two stations"),
            std::string::npos);
}

TEST(NetworkDeclaration, ReportsUnknownStationsAtTheCall) {
  const Loaded scene =
      scene_of("camera main { eye station(of: plan, name: \"hal\")  target (0, 0, 0) }\n");
  EXPECT_NE(scene.report().find("the network has no station 'hal'"), std::string::npos);
  EXPECT_NE(scene.report().find("did you mean 'hall'?"), std::string::npos);
}

std::string leaves_of(const Loaded& scene) {
  std::string text;
  for (const int leaf : scene.shot.derivations.at(0).tree.leaves())
    text +=
        grammar::to_string(scene.shot.derivations[0].tree.nodes[static_cast<size_t>(leaf)].symbol) +
        "; ";
  return text;
}

TEST(Dressing, EveryElementIsASymbol) {
  const Loaded scene = scene_of(
      "grammar dressed {\n  dress plan\n  axiom + passages(of: plan)\n"
      "  Leg(length, slope) if length > 9m -> Block(length) * 2\n"
      "  Block(l) -> - box((l / 2, 1m, 1m)).translate((0, 1m, 0))\n"
      "  Junction(legs, position) if legs == 3 and position[0] == 8m -> + sphere(2m) name "
      "\"hall\"\n"
      "  End(width) -> + cylinder(radius: width, height: 1m)\n"
      "  Sump -> nothing\n}\n"
      "camera main { eye locator(of: dressed, name: \"hall\", up: 1m)  target (0, 0, 0) }\n"
      "volume v = level_set(dressed, voxel: 50cm)\n");
  ASSERT_EQ(scene.report(), "");
  // Legs of 8.3 and 7.3 m are not dressed.
  EXPECT_EQ(leaves_of(scene),
            "+ passages; Leg 1; Leg 2; - box; - box; + sphere name \"hall\"; + cylinder; + "
            "cylinder; ");
  EXPECT_EQ(Vec3d(scene.shot.cameras.at(0).camera->position()), Vec3d(8, 0, 2));
}

TEST(Dressing, ConnectsPlacedShapes) {
  const Loaded scene = scene_of(
      "grammar dressed {\n  dress plan\n"
      "  axiom + passages(of: plan)\n"
      "  Junction -> + sphere(2m) name \"hall\"\n"
      "  Sump -> + sphere(1m) name \"lake\"  + sphere(50cm) connect [\"hall\", \"lake\"] name "
      "\"duct\"\n"
      "}\n"
      "camera main { eye locator(of: dressed, name: \"duct\")  target (0, 0, 0) }\n"
      "volume v = level_set(dressed, voxel: 50cm)\n");
  ASSERT_EQ(scene.report(), "");
  const Vec3d middle = 0.5 * (Vec3d(8, -1, 2) + Vec3d(14, -4, 9));
  EXPECT_LT((Vec3d(scene.shot.cameras.at(0).camera->position()) - middle).length(), 1e-6);
}

TEST(Dressing, TheTreeShowsNamesAndShapesThatAreLeftOut) {
  const Loaded scene = scene_of(
      "grammar rooms {\n"
      "  axiom + sphere(1m).translate((1, 0, 0)) name \"a\"\n"
      "        + sphere(2m) within sphere(1m).translate((90, 0, 0))\n"
      "        + box().rotate(angle: 5deg) label +X name \"b\" + sphere(20cm) connect [\"a\", "
      "\"b\"]\n"
      "}\nvolume v = level_set(rooms, voxel: 50cm)\n");
  ASSERT_EQ(scene.report(), "");
  EXPECT_EQ(leaves_of(scene),
            "+ sphere name \"a\"; + sphere (left out: its middle would be outside of 'within'); + "
            "box name \"b\"; + sphere connect [\"a\", \"b\"]; ");
}

TEST(Dressing, LimitsOfTheGrammarHoldForPlacedShapes) {
  const Loaded scene = scene_of(
      "grammar dressed {\n  dress plan\n  apart 2m\n  within box(size: (100, 100, 100))\n"
      "  Leg -> + sphere(1m) + sphere(1m).translate((2.5, 0, 0))\n"
      "         + sphere(1m).translate((0, 5, 0)) + sphere(1m).translate((0, 90, 0))\n}\n"
      "volume v = level_set(dressed, voxel: 50cm)\n");
  ASSERT_EQ(scene.report(), "");
  EXPECT_EQ(leaves_of(scene).rfind(
                "+ sphere; + sphere (left out: it would be too near to another shape); + sphere; "
                "+ sphere (left out: its middle would be outside of 'within'); ",
                0),
            0u)
      << leaves_of(scene);
}

TEST(Dressing, ReportsFaults) {
  const auto problem = [](const std::string& lines) {
    return scene_of("grammar dressed {\n" + lines + "}\nvolume v = level_set(dressed, voxel: 1m)\n")
        .report();
  };
  const auto has = [](const std::string& report, const std::string& part) {
    EXPECT_NE(report.find(part), std::string::npos) << report;
  };
  has(problem("dress plan\nLeg(wide) -> + sphere(1m)\n"),
      "t.vug:6:5: error: 'Leg' has no attribute 'wide'");
  has(problem("dress plan\nLeg -> + sphere(1m) label +X\n"),
      "'label' has no effect on a shape that is placed on a network");
  has(problem("dress plan\naxiom Room\nRoom -> + sphere(1m)\n"),
      "grammar 'dressed' has no rule for an element of its network");
  has(problem("dress plan\nLeg -> End\nEnd -> nothing\n"),
      "'End' stands for an element of the network, which a grammar cannot add");
  has(problem("dress 3m\nLeg -> + sphere(1m)\n"), "'dress' expects a network, not a length");
  has(problem("Leg -> + sphere(1m)\n"), "grammar 'dressed' has no axiom");
  has(problem("axiom + sphere(1m) slope 100deg\n"),
      "'slope' expects an angle between -90deg and 90deg, not 100deg");
  has(problem("axiom + sphere(1m) slope\n"), "'slope' has no value");
  // The parser knows all clauses.
  for (const ParamInfo& clause : clause_infos())
    has(problem("axiom + sphere(1m) " + clause.name + "\n"), "'" + clause.name + "' has no value");
  has(problem("axiom + sphere(1m) slope 0deg slope 5deg\n"),
      "t.vug:5:31: error: the item has two clauses 'slope'");
  has(problem("slope 0deg\nslope 5deg\naxiom + sphere(1m)\n"),
      "t.vug:6:1: error: the grammar has two options 'slope'");
  has(problem("axiom + sphere(1m) name \"a\" + 1\n"),
      "hint: if it belongs to a clause, write brackets, e.g. name (\"hall \" + n)");
  has(problem("axiom + plan\n"), "hint: write passages(of: ...) for the air of a network");
  has(problem("axiom + passages(of: karst)\n"), "hint: 'karst' is a kind: call it as karst(...)");
  has(problem("dress plam\nLeg -> + sphere(1m)\n"), "hint: did you mean 'plan'?");
  has(problem("axiom + sphere(1m) azimuth [1m]\n"), "'azimuth' expects an angle such as 35deg");
  has(problem("axiom + sphere(1m) apart -1m\n"), "'apart' expects a length of at least 0");
  has(problem("axiom + sphere(1m) name 3\n"), "'name' expects a text such as");
  has(problem("axiom + sphere(1m) name \"\"\n"), "such as \"hall\", not an empty text");
  has(problem("axiom + sphere(1m) azimuth []\n"), "or a list of them, not an empty list");
  has(problem("axiom + sphere(1m) within 3m\n"), "'within' expects a solid");
  for (const char* value :
       {"3m", "\"a\"", "[\"a\"]", "[\"a\", \"b\", \"c\"]", "[\"a\", 2]", "[\"a\", \"\"]", "plan"})
    has(problem(std::string("axiom + sphere(1m) connect ") + value + "\n"),
        "t.vug:5:20: error: 'connect' expects the names of two places, such as");
  has(problem("axiom + sphere(1m) label +X connect [\"a\", \"b\"]\n"),
      "'label' has no effect on a shape that connects two places");
  has(problem("axiom + sphere(1m)\nconnect [\"a\", \"b\"]\n"),
      "t.vug:6:1: error: 'connect' is not an option of a grammar");
  has(problem("axiom + sphere(1m) name \"a\" + sphere(1m) connect [\"a\", \"b\"]\n"),
      "warning: union with 'sphere' has no effect: no earlier shape has the name 'b'");
  has(scene_of("camera main { eye locator(of: sphere(1m), name: \"a\")  target (0, 0, 0) }\n")
          .report(),
      "the solid has no shape with the name 'a'");
}

TEST(NetworkDeclaration, FieldsMasksAndNoisesFollowPassages) {
  const Loaded scene = scene_of(
      "let air  = passages(of: plan, sections: [when(slot, max_width: 2m), when(lens, min_ratio: "
      "2)])\n"
      "let worn = displace(box(size: (60, 30, 60)) - air,\n"
      "  noise: along_flow(noise: scallops(size: 30cm), of: plan, stretch: 1.5), amount: 6cm)\n"
      "let mud  = near(field: height_above_floor(of: plan), from: 40cm, to: 20cm)\n"
      "let path = near(field: centreline(of: part(of: plan, stage: unknown)), from: 1m, to: 50cm)\n"
      "volume rock = level_set(worn, voxel: 1m)\n"
      "mesh cave on rock { paint layer(under: (0.5, 0.4, 0.3), over: (0.2, 0.1, 0.1),\n"
      "  mask: multiply([mud, path])) }\n");
  ASSERT_EQ(scene.report(), "");
  const field::Field& rock = scene.shot.volumes.at(0)->field;
  EXPECT_LT(rock.value({4, 8, 1}), 0);
  EXPECT_GT(rock.value({4, -0.5, 1}), 0);
}

TEST(NetworkDeclaration, CamerasFlyAlongTheNetwork) {
  const std::string camera =
      "camera main {\n"
      "  eye route(of: plan, from: \"mouth\", to: \"sump\", at: (frame - 1) / 10)\n"
      "  target route(of: plan, from: \"mouth\", to: \"sump\", at: (frame - 1) / 10, ahead: 2m)\n"
      "}\n";
  ASSERT_EQ(scene_of(camera).report(), "");
  const Loaded apart = load_text(
      "network two = graph(names: [\"a\", \"b\", \"c\", \"d\"],\n"
      "  at: [(0, 0, 0), (9, 0, 0), (0, 9, 0), (9, 9, 0)], paths: [\"a b\", \"c d\"])\n"
      "camera main { eye route(of: two, from: \"a\", to: \"d\")  target (0, 0, 0) }\n",
      "t.vug", {});
  EXPECT_NE(apart.report().find("no passage leads from 'a' to 'd'"), std::string::npos);
}

TEST(NetworkDeclaration, ACameraThatFliesThroughTheRiverCaveStaysInTheAir) {
  const std::filesystem::path data = VUG_DATA;
  for (int step = 0; step <= 9; ++step) {
    LoadOptions options;
    options.include_folders = {data};
    options.expression =
        "route(of: river, from: \"hall\", to: \"out\", at: " + std::to_string(step) + " / 9)";
    const Loaded scene = load(data / "scenes/karst/river_cave.vug", options);
    ASSERT_EQ(scene.report(), "");
    const Value::Vector* eye = scene.value.get<Value::Vector>();
    ASSERT_NE(eye, nullptr);
    EXPECT_GT(scene.shot.volumes.at(0)->field.value(eye->value), 0.3) << step << " " << eye->value;
  }
}

network::Metrics measures_of_conduit(const std::string& parameters) {
  const Loaded scene = load_text(
      "network cave = karst(preset: conduit, seed: 3, samples: 1500, " + parameters + ")\n",
      "t.vug", {});
  EXPECT_EQ(scene.report(), "") << parameters;
  return network::measure(*scene.shot.networks.at(0).network);
}

TEST(NetworkDeclaration, ParametersOfKarstChangeTheShapeOfPassages) {
  const network::Metrics straight = measures_of_conduit("wander: 0, zigzag: 0, looping: 0");
  const network::Metrics winding = measures_of_conduit("wander: 0.25, zigzag: 0, looping: 0");
  EXPECT_GT(winding.tortuosity, 1.1 * straight.tortuosity);
  const network::Metrics fine = measures_of_conduit("leg_length: 3m, wander: 0, zigzag: 0");
  EXPECT_GT(fine.legs, 3 * measures_of_conduit("leg_length: 12m, wander: 0, zigzag: 0").legs / 2);
}

TEST(NetworkDeclaration, CohesionJoinsThePassagesOfKarst) {
  // Water that follows passages that exist needs less new passage.
  EXPECT_LT(measures_of_conduit("sinks: 9, dead_ends: 0, loops: 0, cohesion: 0.95").length,
            0.9 * measures_of_conduit("sinks: 9, dead_ends: 0, loops: 0, cohesion: 0").length);
}

TEST(NetworkDeclaration, LabelsAreAttributesOfTheMesh) {
  const auto mesh_with = [](const std::string& labels) {
    return scene_of(
        "volume rock = level_set(box(size: (60, 30, 60)) - passages(of: plan), voxel: 1m)\n"
        "mesh cave on rock {\n  labels " +
        labels +
        "\n"
        "  paint layer(under: (0.5, 0.4, 0.3), over: (0.1, 0.1, 0.1), mask: value(name: "
        "\"inlet\"))\n"
        "}\n");
  };
  const std::string inlet = "label(name: \"inlet\", field: sphere(2m))";
  const Loaded scene =
      mesh_with("[" + inlet + ", label(name: \"rest\", field: centreline(of: plan))]");
  ASSERT_EQ(scene.report(), "");
  EXPECT_EQ(shot::element_names(*scene.shot.meshes.at(0)),
            (std::vector<std::string>{"inlet", "rest"}));
  EXPECT_NE(mesh_with("[" + inlet + ", label(name: \"Cd\", field: sphere(1m))]")
                .report()
                .find("the mesh has an attribute 'Cd' already"),
            std::string::npos);
  EXPECT_NE(mesh_with("[for i in 0..256: label(name: \"l\" + i, field: sphere(1m))]")
                .report()
                .find("257 labels are too many"),
            std::string::npos);
}

TEST(NetworkDeclaration, ReportsContradictoryRules) {
  const Loaded scene = scene_of(
      "field air = passages(of: plan, sections: [when(slot, min_width: 3m, max_width: 2m)])\n");
  EXPECT_NE(scene.report().find("no width is at least 'min_width' and at most 'max_width'"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::loading
