// SPDX-License-Identifier: Apache-2.0
// Networks of scenes and the points on them.
#include <gtest/gtest.h>
#include <vug/loading/load.h>

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

}  // namespace
}  // namespace vug::loading
