// SPDX-License-Identifier: Apache-2.0
#include <vug/base/rng.h>
#include <vug/scan/mask.h>
#include <vug/scan/split.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vug::scan {
namespace {

Mask mask_of(const std::vector<std::string>& rows) {
  Mask out(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      out.on[out.index(x, y)] = rows[static_cast<size_t>(y)][static_cast<size_t>(x)] == '#';
  return out;
}

/// All pixels for which `inside` holds, as the only component.
Component group_of(int width, int height, const std::function<bool(int, int)>& inside) {
  Mask mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) mask.on[mask.index(x, y)] = inside(x, y);
  const std::vector<Component> groups = components_of(mask);
  EXPECT_EQ(groups.size(), 1U);
  return groups.at(0);
}

TEST(Mask, DilatesAndErodesAsDefined) {
  RandomStream stream{RandomKey(2)};
  Mask mask(23, 17);
  for (uint8_t& pixel : mask.on) pixel = stream.uniform() < 0.1;
  for (const int radius : {0, 1, 2, 5, 40}) {
    const Mask wide = dilated(mask, radius);
    const Mask thin = eroded(inverted(mask), radius);
    for (int y = 0; y < mask.height; ++y)
      for (int x = 0; x < mask.width; ++x) {
        bool any = false;
        for (int v = std::max(0, y - radius); v <= std::min(mask.height - 1, y + radius); ++v)
          for (int u = std::max(0, x - radius); u <= std::min(mask.width - 1, x + radius); ++u)
            any |= mask.at(u, v);
        ASSERT_EQ(wide.at(x, y), any);
        ASSERT_EQ(thin.at(x, y), !any);
      }
  }
}

TEST(Mask, ClosesGapsAndOpensNecks) {
  EXPECT_EQ(closed(mask_of({"#..#...#"}), 1).on, mask_of({"####...#"}).on);
  EXPECT_EQ(opened(mask_of({"####..", "######", "####..", "####.."}), 1).on,
            mask_of({"####..", "####..", "####..", "####.."}).on);
}

TEST(Mask, ComponentsAreConnectedAlongSides) {
  const std::vector<Component> groups = components_of(mask_of({"#.#.", "###.", "...#", "#..."}));
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].box, (PixelBox{0, 0, 3, 2}));
  EXPECT_EQ(groups[0].mask.on, mask_of({"#.#", "###"}).on);
  EXPECT_EQ(groups[0].pixels, 5);
  EXPECT_EQ(groups[1].box, (PixelBox{3, 2, 4, 3}));
  EXPECT_TRUE(components_of(Mask(1, 1)).empty());
  EXPECT_EQ(components_of(Mask(1, 1, true)).size(), 1U);
  EXPECT_TRUE(components_of(Mask()).empty());
}

TEST(Split, SeparatesTwoDoorsUnderASign) {
  const std::vector<FilledBox> pieces = split(group_of(
      80, 40, [](int x, int y) { return y < 10 || (x >= 5 && x < 30) || (x >= 50 && x < 75); }));
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].box, (PixelBox{0, 0, 80, 10}));
  EXPECT_EQ(pieces[1].box, (PixelBox{5, 10, 30, 40}));
  EXPECT_EQ(pieces[2].box, (PixelBox{50, 10, 75, 40}));
  EXPECT_EQ(pieces[1].pixels, 25 * 30);
}

TEST(Split, CutsBetweenColumnsToo) {
  const std::vector<FilledBox> pieces = split(group_of(
      60, 100, [](int x, int y) { return x < 20 || (y >= 10 && y < 40) || (y >= 60 && y < 90); }));
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].box, (PixelBox{0, 0, 20, 100}));
  EXPECT_EQ(pieces[2].box, (PixelBox{20, 60, 60, 90}));
}

TEST(Split, KeepsTrianglesArchesAndRaggedBoxesWhole) {
  const auto whole = [](const Component& group) { return split(group).size() == 1; };
  EXPECT_TRUE(whole(group_of(60, 40, [](int x, int y) { return 40 * x < 60 * (y + 1); })));
  EXPECT_TRUE(whole(group_of(
      40, 60, [](int x, int y) { return y >= 20 || std::hypot(x - 19.5, y - 20) <= 20; })));
  EXPECT_TRUE(whole(group_of(40, 60, [](int x, int y) { return x >= (y * 7) % 5; })));
  EXPECT_TRUE(whole(group_of(1, 1, [](int, int) { return true; })));
}

}  // namespace
}  // namespace vug::scan
