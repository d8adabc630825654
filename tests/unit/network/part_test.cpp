// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/network/part.h>

namespace vug::network {
namespace {

/// Legs of two surveys, one of them with an inlet, and a leg without a survey.
Network cave() {
  Network network;
  for (const char* name : {"dow.choke1.1", "dow.choke2.1", "dow.choke2.2", "dow.choke2.inlet.1",
                           "dow.choke20.1", "dow.choke20.2"})
    network.stations.push_back(
        {.name = name, .position = Vec3d(static_cast<double>(network.stations.size()), 0, 0)});
  network.legs = {
      {.from = 0, .to = 1, .stage = Stage::phreatic, .survey = "dow.choke1"},
      {.from = 1, .to = 2, .stage = Stage::vadose, .survey = "dow.choke2"},
      {.from = 2, .to = 3, .stage = Stage::phreatic, .survey = "dow.choke2.inlet", .tier = 1},
      {.from = 3, .to = 4, .survey = "dow.choke20"},
      {.from = 4, .to = 5},
  };
  return network;
}

std::vector<int> starts(const PartOptions& options) {
  const Network part = part_of(cave(), options);
  EXPECT_EQ(part.stations.size(), 6u);
  std::vector<int> out;
  for (const Leg& leg : part.legs) out.push_back(leg.from);
  return out;
}

TEST(NetworkPart, NamesAreWholeLevels) {
  using Legs = std::vector<int>;
  EXPECT_EQ(starts({.name = "choke2"}), (Legs{1, 2}));
  EXPECT_EQ(starts({.name = "dow.choke2"}), (Legs{1, 2}));
  EXPECT_EQ(starts({.name = "choke2.inlet"}), (Legs{2}));
  EXPECT_EQ(starts({.name = "choke20"}), (Legs{3, 4}));  // By the names of the last leg's stations.
  EXPECT_EQ(starts({.name = "dow"}), (Legs{0, 1, 2, 3, 4}));
  EXPECT_EQ(starts({.name = "choke2", .rest = true}), (Legs{0, 3, 4}));
}

TEST(NetworkPart, AllConditionsMustHold) {
  using Legs = std::vector<int>;
  EXPECT_EQ(starts({.stage = Stage::phreatic}), (Legs{0, 2}));
  EXPECT_EQ(starts({.stage = Stage::phreatic, .tier = 1}), (Legs{2}));
  EXPECT_EQ(starts({.name = "choke2", .stage = Stage::vadose}), (Legs{1}));
  EXPECT_EQ(starts({.stage = Stage::phreatic, .tier = 1, .rest = true}), (Legs{0, 1, 3, 4}));
}

TEST(NetworkPart, ReportsPartsWithoutLegs) {
  const auto fault = [](const PartOptions& options) {
    try {
      part_of(cave(), options);
    } catch (const Error& error) {
      return std::string(error.what()) + "; " + error.hint();
    }
    return std::string();
  };
  EXPECT_EQ(fault({.name = "chok2"}),
            "no leg of the network belongs to a survey 'chok2'; did you mean 'choke2'?");
  EXPECT_NE(fault({.name = "choke20", .tier = 3}).find("fulfils all conditions"),
            std::string::npos);
  EXPECT_NE(fault({.rest = true}).find("the rest of the network has no legs"), std::string::npos);
}

}  // namespace
}  // namespace vug::network
