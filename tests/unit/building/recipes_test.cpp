// SPDX-License-Identifier: Apache-2.0
// Recipes of cell rules in scenes: named lists of rules, files of data/recipes, and attributes of
// the surroundings.
#include <vug/building/builder.h>
#include <vug/loading/load.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::building {
namespace {

CellLayerPtr skin_of(const std::string& text) {
  loading::LoadOptions options;
  options.include_folders = {VUG_DATA};
  const loading::Loaded loaded = loading::load_text(
      "volume rock = level_set(sphere(1m), voxel: 10cm)\n"
      "mesh wall on rock {}\n" +
          text + "\n",
      "t.vug", options);
  EXPECT_EQ(loaded.report(), "");
  if (!loaded.usable()) return nullptr;
  Builder builder(loaded.shot);
  return builder.cell_layer(loaded.shot.meshes.back()->cells);
}

TEST(Recipes, OfTheLibraryHaveTheirNamedEffect) {
  for (const auto& [name, brings] : std::vector<std::pair<std::string, std::string>>{
           {"limestone_wet", "stain"}, {"mossy", "moss"}, {"dusty", "dust"}}) {
    const CellLayerPtr layer =
        skin_of("include \"recipes/" + name + ".vug\"\ncells skin on wall { spacing 10cm  run " +
                name + " }");
    ASSERT_TRUE(layer) << name;
    const auto& values = layer->simulation.attributes().values<float>(brings);
    const float most = *std::max_element(values.begin(), values.end());
    EXPECT_GT(most, 0) << name;
    EXPECT_LT(*std::min_element(values.begin(), values.end()), most) << name;
  }
}

TEST(Recipes, ListsStandForTheirRules) {
  const CellLayerPtr plain =
      skin_of("cells skin on wall { spacing 15cm  run run_off, moisture, crust }");
  const CellLayerPtr named = skin_of(
      "let wet = [run_off(), moisture()]\ncells skin on wall { spacing 15cm  run wet, crust }");
  ASSERT_TRUE(plain && named);
  for (const char* name : {"stain", "moisture", "crust"})
    EXPECT_EQ(plain->simulation.attributes().values<float>(name),
              named->simulation.attributes().values<float>(name));
}

TEST(CellContext, OfASphereFollowsItsSlope) {
  // Under a uniform sky a convex body has an irradiance of (1 + cosine of the slope) / 2.
  const CellLayerPtr layer = skin_of(
      "cells skin on wall { spacing 8cm  steps 1  run set(attribute: \"a\", to: "
      "add([value(name: \"exposure\"), value(name: \"occlusion\", scale: 10)])) }");
  ASSERT_TRUE(layer);
  const auto& open = layer->simulation.attributes().values<float>("exposure");
  const auto& closed = layer->simulation.attributes().values<float>("occlusion");
  double off = 0;
  for (uint32_t i = 0; i < open.size(); ++i) {
    const double expected = (1 + static_cast<double>(layer->network().normal[i].y)) / 2;
    ASSERT_NEAR(open[i], expected, 0.12);
    ASSERT_LT(closed[i], 0.1f);
    ASSERT_FLOAT_EQ(layer->simulation.attributes().values<float>("a")[i], open[i] + 10 * closed[i]);
    off += static_cast<double>(open[i]) - expected;
  }
  EXPECT_NEAR(off / static_cast<double>(open.size()), 0, 0.02);
}

TEST(CellContext, CurvatureOfASphereFollowsItsRadiusAndIsNegativeInAHollow) {
  for (const auto& [solid, expected] : std::vector<std::pair<std::string, double>>{
           {"sphere(50cm)", 2}, {"sphere(2m) - sphere(1m)", -1}}) {
    const CellLayerPtr layer = skin_of(
        "volume other = level_set(" + solid +
        ", voxel: 5cm)\nmesh face on other {}\n"
        "cells curved on face { spacing 6cm  steps 1  run set(attribute: \"c\", to: value(name: "
        "\"curvature\")) }");
    ASSERT_TRUE(layer);
    double sum = 0, cells = 0;
    for (uint32_t i = 0; i < layer->network().size(); ++i) {
      if (layer->network().position[i].length() > 1.5f)
        continue;  // the outer side of the hollow one
      sum += static_cast<double>(layer->simulation.attributes().values<float>("curvature")[i]);
      ++cells;
    }
    EXPECT_GT(cells, 100);
    EXPECT_NEAR(sum / cells / expected, 1, 0.05) << solid;
  }
}

}  // namespace
}  // namespace vug::building
