// SPDX-License-Identifier: Apache-2.0
// Kept pictures: their recipes, the bound of their memory, and comparisons pixel by pixel.
#include <vug/base/error.h>
#include <vug/workbench/picture_history.h>

#include <gtest/gtest.h>

namespace vug::workbench {
namespace {

/// A picture of one colour.
viewport::PreviewPtr preview(int width, int height, uint8_t value, const std::string& text) {
  auto scene = std::make_shared<viewport::PreviewScene>();
  scene->text = std::make_shared<const std::string>(text);
  auto out = std::make_shared<viewport::Preview>();
  out->width = width, out->height = height;
  out->rgb.assign(static_cast<size_t>(3 * width * height), value);
  auto light =
      std::make_shared<image::Image>(width, height, std::vector<std::string>{"R", "G", "B", "Z"});
  for (float& each : light->pixels) each = static_cast<float>(value) / 100;
  out->light = light;
  out->samples = 16;
  out->mode = viewport::Mode::path;
  out->scene.scene = scene;
  return out;
}

TEST(PictureHistory, KeepsPicturesWithTheirRecipes) {
  PictureHistory history;
  const viewport::PreviewPtr live = preview(4, 2, 10, "# one\n");
  EXPECT_EQ(history.displayed(live), nullptr) << "the picture of the viewport itself";
  EXPECT_EQ(history.keep(*live), 1);
  EXPECT_EQ(history.keep(*preview(4, 2, 30, "# two\n")), 2);
  EXPECT_EQ(*history.find(2)->text, "# two\n");
  EXPECT_EQ(history.find(1)->settings(), "path, 4 x 2, 16 samples");
  history.show(2);
  EXPECT_EQ(history.displayed(live)->rgb, std::vector<uint8_t>(24, 30));
  history.forget(2);
  EXPECT_EQ(history.shown(), 0) << "the picture of the viewport again";
  EXPECT_THROW(history.show(2), Error);
  EXPECT_THROW(history.find(7), Error);
  EXPECT_EQ(history.keep(*live), 3) << "numbers are not used again";
}

TEST(PictureHistory, HasABound) {
  const viewport::PreviewPtr picture = preview(10, 10, 1, "text");
  const size_t bytes = 100 * 3 + 100 * 3 * sizeof(float) + 4;
  PictureHistory history(3 * bytes);
  for (int i = 0; i < 5; ++i) history.keep(*picture);
  ASSERT_EQ(history.all().size(), 3u);
  EXPECT_EQ(history.all().front()->number, 3) << "the oldest ones are forgotten";
  EXPECT_EQ(history.all().front()->bytes(), bytes);
  PictureHistory small(1);
  small.keep(*picture);
  small.keep(*picture);
  ASSERT_EQ(small.all().size(), 1u) << "the newest one stays";
  EXPECT_EQ(small.all().front()->number, 2);
}

TEST(PictureHistory, AWipeShowsOnePictureAtEachSide) {
  PictureHistory history;
  const viewport::PreviewPtr live = preview(4, 2, 10, "");
  history.keep(*preview(4, 2, 30, ""));
  history.set_reference(1);
  history.compare(ComparisonMode::wipe);
  for (const int first : {0, 1, 2, 4}) {
    history.set_edge(first / 4.0);
    const auto shown = history.displayed(live);
    for (int x = 0; x < 4; ++x)
      for (int y = 0; y < 2; ++y)
        for (int c = 0; c < 3; ++c)
          EXPECT_EQ(shown->rgb[static_cast<size_t>(3 * (4 * y + x) + c)], x < first ? 10 : 30);
  }
  history.set_edge(7);
  EXPECT_EQ(history.edge(), 1) << "the edge stays in the picture";
}

TEST(PictureHistory, DifferencesAreAbsolute) {
  PictureHistory history;
  const viewport::PreviewPtr live = preview(4, 2, 10, "");
  history.keep(*preview(4, 2, 30, ""));
  history.keep(*preview(2, 1, 25, ""));
  history.compare(ComparisonMode::difference);
  EXPECT_EQ(history.displayed(live)->rgb, std::vector<uint8_t>(24, 0)) << "with itself";
  EXPECT_EQ(history.difference(live), 0);
  history.set_reference(1);
  EXPECT_EQ(history.displayed(live)->rgb, std::vector<uint8_t>(24, 20));
  EXPECT_NEAR(history.difference(live), 0.2, 1e-6) << "of the light";
  history.set_reference(2);
  EXPECT_EQ(history.displayed(live)->rgb, std::vector<uint8_t>(24, 15)) << "scaled";
  EXPECT_THROW(history.difference(live), Error) << "of another size";
  history.show(2);
  history.set_reference(1);
  EXPECT_EQ(history.displayed(nullptr)->rgb, std::vector<uint8_t>(6, 5));
}

TEST(PictureHistory, ComparisonsHaveNames) {
  EXPECT_EQ(comparison_of("difference"), ComparisonMode::difference);
  EXPECT_THROW(comparison_of("blink"), Error);
}

}  // namespace
}  // namespace vug::workbench
