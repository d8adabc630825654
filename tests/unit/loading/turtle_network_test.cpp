// SPDX-License-Identifier: Apache-2.0
// Networks that the turtle of an L-system draws.
#include <gtest/gtest.h>
#include <vug/loading/load.h>

#include <cmath>

namespace vug::loading {
namespace {

// A trunk with a branch, which returns to its start along a square.
const std::string kTurtle =
    "grammar walk: lsystem {\n"
    "  instances hall, sump\n"
    "  axiom !(2m) F(8m) [ +(90deg) F(3m) sump ] !(3m) F(6m) hall +(90deg) F(4m) +(90deg) F(4m) "
    "+(90deg) F(4m) +(90deg) F(4m)\n"
    "}\n";

Loaded turtle_of(const std::string& arguments, const std::string& text = "") {
  return load_text(kTurtle + "network drawn = turtle(of: walk" + arguments + ")\n" + text, "t.vug",
                   {});
}

TEST(TurtleNetwork, LinesAreLegsAndReturnsCloseLoops) {
  const Loaded scene = turtle_of("");
  ASSERT_EQ(scene.report(), "");
  const network::Network& drawn = *scene.shot.networks.at(0).network;
  // The start, the fork, the hall, three further corners of the square and the sump.
  EXPECT_EQ(drawn.stations.size(), 7u);
  EXPECT_EQ(drawn.legs.size(), 7u);
  double length = 0;
  for (const network::Leg& leg : drawn.legs) length += network::leg_vector(drawn, leg).length();
  EXPECT_NEAR(length, 8 + 3 + 6 + 4 * 4, 1e-9);
}

const network::Station& station_named(const network::Network& network, const std::string& name) {
  for (const network::Station& station : network.stations)
    if (station.name == name) return station;
  throw Error(ErrorCode::bad_input, "no station " + name);
}

TEST(TurtleNetwork, InstancesNameStationsAndWidthsAreThoseOfLines) {
  const Loaded scene = turtle_of(", ratio: 2");
  ASSERT_EQ(scene.report(), "");
  const network::Network& drawn = *scene.shot.networks.at(0).network;
  const network::Station& hall = station_named(drawn, "hall");
  EXPECT_NEAR(hall.position.length(), 14, 1e-9);
  EXPECT_NEAR(*hall.section->left + *hall.section->right, 3, 1e-9);
  EXPECT_NEAR(*hall.section->up + *hall.section->down, 1.5, 1e-9);
  const network::Station& sump = station_named(drawn, "sump");
  EXPECT_NEAR(*sump.section->left + *sump.section->right, 2, 1e-9);
  EXPECT_NEAR(sump.position.length(), std::sqrt(8. * 8 + 3 * 3), 1e-9);
}

TEST(TurtleNetwork, WaterRunsAsDrawnOrAgainstIt) {
  const Loaded down = turtle_of("");
  const Loaded up = turtle_of(", upstream: true");
  const auto& legs = down.shot.networks.at(0).network->legs;
  const auto& reversed = up.shot.networks.at(0).network->legs;
  ASSERT_EQ(legs.size(), reversed.size());
  for (size_t i = 0; i < legs.size(); ++i) {
    EXPECT_EQ(legs[i].from, reversed[i].to);
    EXPECT_EQ(legs[i].to, reversed[i].from);
  }
}

TEST(TurtleNetwork, ReportsDrawingsThatAreNotCaves) {
  const auto problem = [](const std::string& axiom) {
    return load_text("grammar walk: lsystem {\n  axiom " + axiom +
                         "\n}\nnetwork drawn = turtle(of: walk)\n",
                     "t.vug", {})
        .report();
  };
  EXPECT_NE(problem("+(90deg)").find("t.vug:4:17: error: the turtle of 'walk' draws no line"),
            std::string::npos)
      << problem("+(90deg)");
  EXPECT_NE(problem("!(20000m) F(1m)").find("draws a passage of 20000 m width"), std::string::npos);
}

}  // namespace
}  // namespace vug::loading
