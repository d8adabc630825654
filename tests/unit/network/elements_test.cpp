// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/network/elements.h>

namespace vug::network {
namespace {

/// A leg from an entrance to a fork, from which one passage leads to a sump and one upwards.
Network cave_with_sump() {
  Network network;
  network.stations = {{.name = "mouth", .position = {0, 0, 0}, .flags = {.entrance = true}},
                      {.name = "fork", .position = {10, 0, 0}},
                      {.name = "cave.sump2", .position = {10, -4, 8}},
                      {.name = "loft", .position = {10, 6, 0}}};
  network.stations[0].section = CrossSection{1, 2, 3, 1};
  network.stations[1].section = CrossSection{2, 3, {}, 1};
  network.legs = {{.from = 0, .to = 1},
                  {.from = 1, .to = 2},
                  {.from = 1, .to = 3},
                  {.from = 1, .to = 3},
                  {.from = 0, .to = 3, .surface = true}};
  return network;
}

TEST(Elements, EachHasItsKind) {
  const Network network = cave_with_sump();
  EXPECT_EQ(elements(network, ElementKind::leg).size(), 3u);
  const auto junctions = elements(network, ElementKind::junction);
  ASSERT_EQ(junctions.size(), 1u);
  EXPECT_EQ(junctions[0].index, 1);
  EXPECT_EQ(junctions[0].legs, 3);
  const auto ends = elements(network, ElementKind::end);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].index, 0);
  EXPECT_EQ(ends[1].index, 3);
  const auto sumps = elements(network, ElementKind::sump);
  ASSERT_EQ(sumps.size(), 1u);
  EXPECT_EQ(sumps[0].index, 2);
}

TEST(Elements, AFloodedEndIsASump) {
  Network network = cave_with_sump();
  network.legs[2].stage = Stage::phreatic;
  EXPECT_EQ(elements(network, ElementKind::sump).size(), 2u);
  network.legs[2].tier = 1;  // an older water table: dry today
  EXPECT_EQ(elements(network, ElementKind::sump).size(), 1u);
}

TEST(Elements, FramesAreUprightAndRightHanded) {
  const Network network = cave_with_sump();
  for (const ElementKind kind :
       {ElementKind::leg, ElementKind::junction, ElementKind::end, ElementKind::sump})
    for (const Element& element : elements(network, kind)) {
      EXPECT_NEAR(element.frame.determinant(), 1, 1e-12);
      EXPECT_NEAR(element.frame.column(2).y, 0, 1e-12);
      EXPECT_GE(element.frame.column(1).y, -1e-12);
    }
  const auto legs = elements(network, ElementKind::leg);
  EXPECT_EQ(legs[0].frame.origin(), Vec3d(5, 0, 0));
  EXPECT_EQ(legs[0].frame.column(0), Vec3d(1, 0, 0));
  EXPECT_EQ(legs[0].frame.column(1), Vec3d(0, 1, 0));
  // At an end, x points out of the cave.
  EXPECT_EQ(elements(network, ElementKind::end)[0].frame.column(0), Vec3d(-1, 0, 0));
  EXPECT_EQ(elements(network, ElementKind::end)[1].frame.column(0), Vec3d(0, 1, 0));
}

TEST(Elements, SizesAreThoseOfCompleteSections) {
  const Network network = cave_with_sump();
  const auto legs = elements(network, ElementKind::leg);
  EXPECT_EQ(size_of(network, legs[0]).width, 4.0);
  EXPECT_EQ(size_of(network, legs[0]).height, 4.0) << "only the entrance has both distances";
  EXPECT_EQ(size_of(network, legs[2]).width, 5.0);
  EXPECT_FALSE(size_of(network, legs[2]).height);
  EXPECT_EQ(size_of(network, elements(network, ElementKind::end)[0]).height, 4.0);
}

}  // namespace
}  // namespace vug::network
