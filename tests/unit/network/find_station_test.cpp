// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/network/find_station.h>

namespace vug::network {
namespace {

Network named(const std::vector<std::string>& names) {
  Network network;
  for (const std::string& name : names)
    network.stations.push_back(
        {.name = name, .position = Vec3d(static_cast<double>(network.stations.size()), 0, 0)});
  return network;
}

std::string problem(const Network& network, std::string_view name) {
  try {
    find_station(network, name);
  } catch (const Error& error) {
    return std::string(error.what()) + " (" + error.hint() + ")";
  }
  return "";
}

TEST(FindStation, FindsFullNamesAndTheirLastLevels) {
  const Network network = named({"dow.choke2.14", "dow.choke2.4", "ppot.14x", "14"});
  EXPECT_EQ(find_station(network, "dow.choke2.4"), 1);
  EXPECT_EQ(find_station(network, "choke2.14"), 0);
  EXPECT_EQ(find_station(network, "4"), 1);
  // A full name comes before a name that only ends in it.
  EXPECT_EQ(find_station(network, "14"), 3);
}

TEST(FindStation, EquatedNamesAreOneStation) {
  Network network = named({"creek.mouth", "creek.stream.hall", "creek.hall"});
  EXPECT_NE(problem(network, "hall"), "");
  network.stations.pop_back();
  network.stations[1].equated = {"creek.upper.hall", "creek.9"};
  EXPECT_EQ(find_station(network, "hall"), 1);
  EXPECT_EQ(find_station(network, "upper.hall"), 1);
  EXPECT_EQ(find_station(network, "creek.9"), 1);
}

TEST(FindStation, ReportsUnknownAndAmbiguousNames) {
  const Network network = named({"dow.entrance", "ppot.entrance", "dow.1", ""});
  EXPECT_EQ(problem(network, "dow.entrence"),
            "the network has no station 'dow.entrence' (did you mean 'dow.entrance'?)");
  EXPECT_EQ(problem(network, "entrance"),
            "2 stations end in 'entrance' (write more of its name: dow.entrance, ppot.entrance)");
  EXPECT_NE(problem(network, "").find("no station ''"), std::string::npos);
  EXPECT_EQ(problem(network, "sump"),
            "the network has no station 'sump' (among its 4 stations are "
            "dow.entrance, ppot.entrance, dow.1)");
  EXPECT_EQ(problem(named({"creek.stream.6", "creek.upper.2"}), "stream.7"),
            "the network has no station 'stream.7' (did you mean 'stream.6'?)");
  EXPECT_EQ(problem({}, "a"), "the network has no station 'a' (its stations have no names)");
}

}  // namespace
}  // namespace vug::network
