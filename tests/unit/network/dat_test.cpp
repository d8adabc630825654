// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/network/dat.h>

namespace vug::network {
namespace {

Network parse(const std::string& nodes, const std::string& links, bool recenter = false) {
  return parse_dat({nodes, "a_nodes.dat"}, {links, "a_links.dat"}, {.recenter = recenter});
}

/// "file:line" of the error that two texts cause.
std::string fault(const std::string& nodes, const std::string& links) {
  try {
    parse(nodes, links);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    return error.where().file + ":" + std::to_string(error.where().line);
  }
  return "none";
}

TEST(Dat, TurnsTheHeightUp) {
  const Network network = parse("1 2 3\n\n# comment\n4 5 6.5 # note\n", "1 2\r\n");
  ASSERT_EQ(network.stations.size(), 2u);
  EXPECT_EQ(network.stations[0].position, Vec3d(1, 3, -2));
  EXPECT_EQ(network.stations[1].position, Vec3d(4, 6.5, -5));
  ASSERT_EQ(network.legs.size(), 1u);
  EXPECT_EQ(network.legs[0].to, 1);
  EXPECT_EQ(network.origin, Vec3d(0.0));
}

TEST(Dat, RecentersAroundWholeMetres) {
  const Network network = parse("739893.25 6301812 710\n739903.25 6301812 701\n", "1 2", true);
  EXPECT_EQ(network.origin, Vec3d(739898, 6301812, 706));
  EXPECT_EQ(network.stations[0].position, Vec3d(-4.75, 4, 0));
}

TEST(Dat, RefusesOriginsFarFromTheStations) {
  const char* const nodes = "739893.25 6301812 710\n739903.25 6301812 701\n";
  try {
    parse(nodes, "1 2");
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    EXPECT_NE(error.hint().find("'origin: (739898, 6301812, 706)'"), std::string::npos)
        << error.hint();
  }
  const Vec3d near(739000, 6301000, 0);
  const Network network = parse_dat({nodes, ""}, {"1 2", ""}, {.origin = near});
  EXPECT_EQ(network.origin, near);
  EXPECT_EQ(network.stations[0].position, Vec3d(893.25, 710, -812));
  EXPECT_THROW(parse_dat({nodes, ""}, {"1 2", ""}, {.recenter = false, .origin = near}), Error);
}

TEST(Dat, WritesTheNumbersItRead) {
  const std::string nodes = "9893.1 1812.7 710.123456789\n0.1 -0.2 1e-05\n";
  const Network network = parse(nodes, "2 1\n");
  EXPECT_EQ(nodes_dat(network), nodes);
  EXPECT_EQ(links_dat(network), "2 1\n");
}

TEST(Dat, ReadsThePairOfAFile) {
  const ScratchFolder folder("dat");
  const Network network = parse("1 2 3\n4 5 6\n7 8 10\n", "1 2\n3 2\n");
  write_dat(network, folder.path() / "cave_nodes.dat");
  const Network again = read_dat(folder.path() / "cave_links.dat", {.recenter = false});
  EXPECT_EQ(nodes_dat(again), nodes_dat(network));
  EXPECT_EQ(links_dat(again), links_dat(network));
  EXPECT_THROW(read_dat(folder.path() / "cave.dat"), Error);
  EXPECT_THROW(read_dat(folder.path() / "other_nodes.dat"), Error);
}

TEST(Dat, ReportsTheLineOfAFault) {
  EXPECT_EQ(fault("1 2 3\n4 5 6\n", "1 2\n"), "none");
  EXPECT_EQ(fault("1 2 3\n4 5\n", ""), "a_nodes.dat:2");
  EXPECT_EQ(fault("1 2 3 4\n", ""), "a_nodes.dat:1");
  EXPECT_EQ(fault("1 2 3\n\n4 nan 6\n", ""), "a_nodes.dat:3");
  EXPECT_EQ(fault("1 2 1e300\n", ""), "a_nodes.dat:1");
  EXPECT_EQ(fault("1 2 x\n", ""), "a_nodes.dat:1");
  EXPECT_EQ(fault(std::string("1 2\0 3\n", 7), ""), "a_nodes.dat:1");
  EXPECT_EQ(fault("1 2 3\n4 5 6\n", "1 2\n2 3\n"), "a_links.dat:2");
  EXPECT_EQ(fault("1 2 3\n4 5 6\n", "0 1\n"), "a_links.dat:1");
  EXPECT_EQ(fault("1 2 3\n4 5 6\n", "1 2 2\n"), "a_links.dat:1");
  EXPECT_EQ(fault("1 2 3\n4 5 6\n", "1\n"), "a_links.dat:1");
  EXPECT_EQ(fault("1 2 3\n4 5 6\n", "1 1.5\n"), "a_links.dat:1");
  EXPECT_EQ(fault("1 2 3\n4 5 6\n", "1 99999999999999999999\n"), "a_links.dat:1");
}

TEST(Dat, AcceptsEmptyFiles) {
  EXPECT_TRUE(parse("", "").stations.empty());
  EXPECT_TRUE(parse("\xEF\xBB\xBF# nothing\n", "\n\n", true).legs.empty());
}

}  // namespace
}  // namespace vug::network
