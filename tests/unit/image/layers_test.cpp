// SPDX-License-Identifier: Apache-2.0
#include <vug/image/layers.h>

#include <gtest/gtest.h>

namespace vug::image {
namespace {

TEST(Layers, GatherByNameWithTheBeautyFirst) {
  const auto layers = layers_of({"Z", "albedo.B", "R", "G", "B", "A", "albedo.R", "a.b.X"});
  const std::vector<Layer> expected = {{"beauty", {"R", "G", "B"}},
                                       {"Z", {"Z"}},
                                       {"albedo", {"albedo.B", "albedo.R"}},
                                       {"A", {"A"}},
                                       {"a.b", {"a.b.X"}}};
  EXPECT_EQ(layers, expected);
  EXPECT_TRUE(layers[0].colour());
  EXPECT_FALSE(layers[2].colour());
}

TEST(Layers, ExtractDropsTheLayersName) {
  Image picture(1, 1, {"Z", "N.X", "N.Y"});
  picture.pixels = {1, 2, 3};
  const Image normal = extract(picture, layers_of(picture.channels).at(1));
  EXPECT_EQ(normal.channels, (std::vector<std::string>{"X", "Y"}));
  EXPECT_EQ(normal.pixels, (std::vector<float>{2, 3}));
}

}  // namespace
}  // namespace vug::image
