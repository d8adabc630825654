// SPDX-License-Identifier: Apache-2.0
// Values of params and lets as inlay hints.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/language/inlay_hints.h>
#include <vug/language/values.h>
#include <vug/loading/load.h>

namespace vug::language {
namespace {

TEST(Values, OfParamsEqualThoseOfTheLoadedScene) {
  const Workspace workspace(with_data());
  int compared = 0;
  for (const auto& scene : data_scenes()) {
    if (scene.string().find("/data/scenes/") == std::string::npos) continue;
    const AnalysisPtr text = workspace.analyse(scene);
    if (text->document.params.empty() || text->document.sources.size() > 1 || compared > 20)
      continue;
    const auto values = values_of(*text);
    loading::LoadOptions options;
    options.include_folders = loading::data_folders();
    const loading::Loaded loaded = loading::load(scene, options);
    for (const loading::Parameter& each : loaded.parameters) {
      const Number* number = each.value.get<Number>();
      if (!number) continue;
      EXPECT_EQ(values.at(each.name), quantity_text(number->value, number->dimension)) << scene;
      ++compared;
    }
  }
  EXPECT_GT(compared, 15);
}

TEST(Values, HintsShowComputedValuesOnly) {
  const MarkedText text(
      "param a = 2cm\nparam b = 3 * a\nlet c = (a, b, 1m)\nlet d = sphere(a)\nlet e = [1, 2]\n");
  const auto hints = inlay_hints(*text.analysis, 1, 5);
  ASSERT_EQ(hints.size(), 2u);
  EXPECT_EQ(hints[0].text, " = 0.06m");
  EXPECT_EQ(hints[0].position, (Position{2, 16}));
  EXPECT_EQ(hints[1].position.line, 3);
  EXPECT_TRUE(inlay_hints(*text.analysis, 4, 5).empty());
}

}  // namespace
}  // namespace vug::language
