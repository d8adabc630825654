// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/scan/scores.h>

#include <gtest/gtest.h>

namespace vug::scan {
namespace {

Box box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y1}}; }

TEST(Scores, IouOfKnownBoxes) {
  EXPECT_EQ(iou(box(0, 0, 2, 2), box(0, 0, 2, 2)), 1);
  EXPECT_EQ(iou(box(0, 0, 2, 2), box(1, 0, 3, 2)), 1.0 / 3);
  EXPECT_EQ(iou(box(0, 0, 2, 2), box(2, 0, 3, 2)), 0);
  EXPECT_EQ(iou(box(0, 0, 2, 2), box(5, 5, 6, 6)), 0);
  EXPECT_EQ(iou(box(1, 1, 1, 1), box(1, 1, 1, 1)), 0);
  EXPECT_EQ(iou(Box(), box(0, 0, 1, 1)), 0);
}

TEST(Scores, UnionAreaCountsOverlapsOnce) {
  EXPECT_EQ(union_area({}), 0);
  EXPECT_EQ(union_area({box(0, 0, 2, 2), box(1, 1, 3, 3), box(1, 1, 3, 3), Box()}), 7);
  std::vector<Box> boxes;
  RandomStream stream{RandomKey(4)};
  for (int i = 0; i < 30; ++i) {
    const int x = static_cast<int>(stream.below(20)), y = static_cast<int>(stream.below(20));
    const double right = x + 1.0 + stream.below(6), top = y + 1.0 + stream.below(6);
    boxes.push_back(box(x, y, right, top));
  }
  int cells = 0;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 30; ++x)
      cells += std::any_of(boxes.begin(), boxes.end(),
                           [&](const Box& b) { return b.intersects(Vec2d(x + 0.5, y + 0.5)); });
  EXPECT_EQ(union_area(boxes), cells);
}

TEST(Scores, EachObjectCountsOnce) {
  const std::vector<Box> truth = {box(0, 0, 2, 2), box(4, 0, 6, 2), box(8, 0, 10, 2)};
  // Two match the first object, none the second well enough; one is a false positive.
  const std::vector<Box> found = {box(0, 0, 2, 1.5), box(0, 0, 2, 2), box(4, 0, 5, 2),
                                  box(8, 0, 10, 2.5), box(0, 5, 1, 6)};
  const Scores scores = score(found, truth);
  EXPECT_EQ(scores.matched, 2U);
  EXPECT_EQ(scores.truth[0].found, 1U);
  EXPECT_FALSE(scores.truth[1].found);
  EXPECT_EQ(scores.truth[1].best, 0.5);  // Equal to the threshold, which is not enough.
  EXPECT_EQ(scores.truth[2].best, 0.8);
  EXPECT_DOUBLE_EQ(scores.precision, 0.4);
  EXPECT_DOUBLE_EQ(scores.recall, 2.0 / 3);
  EXPECT_DOUBLE_EQ(scores.area_iou, 10.0 / 14);
  const Scores none = score(std::vector<Box>(), std::vector<Box>());
  EXPECT_EQ(none.precision + none.recall + none.area_iou, 0);
}

TEST(Scores, MapsOfRectanglesScoreLikeTheRectangles) {
  const std::vector<Box> truth = {box(1, 1, 3, 3), box(4, 0, 6, 2)};
  const std::vector<Box> found = {box(1, 1, 3, 2.5), box(3.5, 0.5, 6.5, 2), box(-1, 3, 0.5, 9)};
  ObjectMap map{20, 12, 0.5, std::vector<uint32_t>(240, 0)};
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 20; ++x)
      for (uint32_t t = 0; t < 2; ++t)
        if (truth[t].intersects(Vec2d(0.5 * x + 0.25, 0.5 * (12 - y) - 0.25)))
          map.label[static_cast<size_t>(20 * y + x)] = t + 1;
  const Scores exact = score(found, truth), mapped = score(found, map);
  EXPECT_EQ(mapped.matched, exact.matched);
  EXPECT_DOUBLE_EQ(mapped.area_iou, exact.area_iou);
  for (size_t t = 0; t < 2; ++t) EXPECT_DOUBLE_EQ(mapped.truth[t].best, exact.truth[t].best) << t;
  map.label.pop_back();
  EXPECT_THROW(score(found, map), Error);
  map.label.push_back(4000000000);
  EXPECT_THROW(score(found, map), Error);
}

}  // namespace
}  // namespace vug::scan
