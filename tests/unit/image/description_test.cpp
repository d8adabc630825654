// SPDX-License-Identifier: Apache-2.0
// Differences of images in words: colours, amounts and places.
#include <vug/base/rng.h>
#include <vug/image/description.h>
#include <vug/image/report.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace vug::image {
namespace {

constexpr int kAcross = 96, kDown = 64;

/// The same image twice; `change` may change the pixels of the test.
Comparison pair_of(const std::vector<std::string>& channels,
                   const std::function<void(Image&, int x, int y)>& change) {
  Comparison pair;
  pair.reference = Image(kAcross, kDown, channels);
  RandomStream random(RandomKey(1).at("description"));
  for (float& value : pair.reference.pixels)
    value = static_cast<float>(0.5 + 0.1 * random.uniform());
  pair.test = pair.reference;
  for (int y = 0; y < kDown; ++y)
    for (int x = 0; x < kAcross; ++x) change(pair.test, x, y);
  return pair;
}

std::string colours(const std::function<void(Image&, int x, int y)>& change,
                    const std::string& layer = "beauty") {
  return describe_difference(pair_of({"R", "G", "B"}, change), layer);
}

TEST(Description, EqualImagesHaveNone) {
  EXPECT_EQ(colours([](Image&, int, int) {}), "");
}

TEST(Description, ColoursAreNamedWithAmountAndPlace) {
  // Twice as strong in each direction towards the lower right corner, 8 % on average.
  const auto red = [](Image& image, int x, int y) {
    const float u = static_cast<float>(x) / kAcross, v = static_cast<float>(y) / kDown;
    image.at(x, y, 0) *= 1 + 0.72f * u * u * v * v;
  };
  EXPECT_EQ(colours(red), "red is 8 % brighter, most at the lower right");
  EXPECT_EQ(colours(red, "albedo"), "albedo: red is 8 % brighter, most at the lower right");
}

TEST(Description, AChangeOfAllColoursIsOneOfThePicture) {
  const auto gain = [](float red, float green, float blue) {
    return [=](Image& image, int x, int y) {
      image.at(x, y, 0) *= red, image.at(x, y, 1) *= green, image.at(x, y, 2) *= blue;
    };
  };
  EXPECT_EQ(colours(gain(0.9f, 0.9f, 0.9f)), "the picture is 10 % darker everywhere");
  EXPECT_EQ(colours(gain(0.996f, 0.996f, 0.996f)), "the picture is 0.4 % darker everywhere");
  EXPECT_EQ(colours(gain(3, 3, 3)), "the picture is 3 times as bright everywhere");
  EXPECT_EQ(colours(gain(1.05f, 1.05f, 0.8f)),
            "red and green are 5 % brighter, blue is 20 % darker everywhere");
}

TEST(Description, PlacesAreCornersSidesOrOnlyOnePart) {
  const auto inside = [](int left, int top, int right, int bottom) {
    return colours([=](Image& image, int x, int y) {
      if (x >= left && x < right && y >= top && y < bottom)
        for (size_t c = 0; c < 3; ++c) image.at(x, y, c) *= 1.5f;
    });
  };
  EXPECT_EQ(inside(4, 4, 20, 16), "the picture is 2 % brighter, only at the upper left");
  EXPECT_EQ(inside(40, 24, 56, 40), "the picture is 2 % brighter, only in the middle");
  EXPECT_EQ(inside(0, 0, 96, 16), "the picture is 12 % brighter, most at the top");
  EXPECT_EQ(inside(80, 0, 96, 64), "the picture is 8 % brighter, most at the right");
}

TEST(Description, AMovedLightMakesPartsBrighterAndOthersDarker) {
  const std::string said = colours([](Image& image, int x, int y) {
    if (y < 40) return;
    for (size_t c = 0; c < 3; ++c) image.at(x, y, c) += x < 48 ? 0.1f : -0.1f;
  });
  EXPECT_EQ(said, "parts are brighter and others darker, most at the bottom");
}

TEST(Description, OtherValuesDifferInAShareOfThePixels) {
  const auto changed = [](int rows) {
    return describe_difference(pair_of({"Z"},
                                       [=](Image& image, int x, int y) {
                                         if (y < rows) image.at(x, y) += 1;
                                       }),
                               "Z");
  };
  EXPECT_EQ(changed(8), "Z differs in 12 % of the pixels, most at the top");
  EXPECT_EQ(changed(kDown), "Z differs in all pixels");
}

TEST(Description, MaskedPixelsDoNotCountAndInfiniteOnesDo) {
  Comparison pair = pair_of({"R", "G", "B"}, [](Image& image, int x, int y) {
    if (x < 48) image.at(x, y, 2) *= 0.5f;
  });
  pair.mask.assign(pair.test.pixel_count(), 1);
  for (size_t p = 0; p < pair.mask.size(); ++p) pair.mask[p] = p % kAcross < 48 ? 0 : 1;
  EXPECT_EQ(describe_difference(pair, "beauty"), "");
  pair.test.at(90, 60, 0) = std::numeric_limits<float>::infinity();
  EXPECT_NE(describe_difference(pair, "beauty").find("1 pixel is not finite in one picture"),
            std::string::npos);
}

TEST(Description, TheVerdictComesFirstAndHasNoStatistics) {
  const auto under_test = [](double gain) {
    ImageUnderTest out;
    out.image = Image(kAcross, kDown, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
    RandomStream random(RandomKey(static_cast<uint64_t>(1000 * gain)).at("description"));
    for (int y = 0; y < kDown; ++y)
      for (int x = 0; x < kAcross; ++x)
        for (size_t c = 0; c < 3; ++c) {
          out.image.at(x, y, c) =
              static_cast<float>((c == 0 ? gain : 1) * (1 + 0.05 * random.normal()));
          out.image.at(x, y, c + 3) = 0.0025f;
        }
    return out;
  };
  const Diff found = diff(under_test(1), under_test(1.08));
  EXPECT_EQ(verdict_text(found), "different: red is 8 % brighter everywhere");
  EXPECT_TRUE(to_table(found).starts_with(verdict_text(found) + "\n"));
  EXPECT_NE(to_table(found).find("\nreasons: "), std::string::npos);
}

}  // namespace
}  // namespace vug::image
