// SPDX-License-Identifier: Apache-2.0
#include "derived.h"

namespace vug::facade {
namespace {

TEST(Splits, RowsFromTheBottomWithLengthsProportionsAndPercentages) {
  const Sample s = facade_of("axiom A\n A -> rows(3m, shop, 1, window, 10%, wall, 2, door)");
  ASSERT_EQ(s.said, "");
  ASSERT_EQ(s.tree.nodes.size(), 5u);
  expect_rect(s.rects("shop")[0], 0, 0, 12, 3);
  expect_rect(s.rects("window")[0], 0, 3, 12, 1.7);
  expect_rect(s.rects("wall")[0], 0, 4.7, 12, 0.9);
  expect_rect(s.rects("door")[0], 0, 5.6, 12, 3.4);
}

TEST(Splits, ColumnsFromTheLeftAndSplitsInside) {
  const Sample s = facade_of("axiom A\n A -> columns(2m, wall, 1, rows(1, door, 2, window))");
  ASSERT_EQ(s.said, "");
  expect_rect(s.rects("door")[0], 2, 0, 10, 3);
  expect_rect(s.rects("window")[0], 2, 3, 10, 6);
}

TEST(Splits, RepeatStretchesToFill) {
  const Sample s = facade_of("axiom A\n A -> repeat(x, 2.5m, window)");
  ASSERT_EQ(s.rects("window").size(), 4u);
  expect_rect(s.rects("window")[3], 9, 0, 3, 9);
  EXPECT_EQ(s.tree.nodes.size(), 2u) << "identical: derived once";
  const Sample apart =
      facade_of("axiom A\n A -> repeat(y, window, count: 3, gap: 1.5m, alike: false)");
  ASSERT_EQ(apart.tree.nodes.size(), 4u);
  expect_rect(apart.rects("window")[2], 0, 7, 12, 2);
}

TEST(Splits, MirrorDerivesTheSideOnce) {
  const Sample s =
      facade_of("axiom A\n A -> mirror(Side, 2m, door)\n Side -> columns(1m, window, 1, wall)");
  ASSERT_EQ(s.said, "");
  EXPECT_EQ(s.tree.nodes.size(), 5u);
  ASSERT_EQ(s.rects("window").size(), 2u);
  expect_rect(s.rects("window")[0], 0, 0, 1, 9);
  expect_rect(s.rects("window")[1], 11, 0, 1, 9);
  expect_rect(s.rects("wall")[1], 7, 0, 4, 9);
  expect_rect(s.rects("door")[0], 5, 0, 2, 9);
  EXPECT_TRUE(element_instances(s.tree)[1].mirrored);
}

TEST(Splits, MirrorsInRepeatsInMirrors) {
  // A scope that does not start at 0, mirrored within itself, repeated, and mirrored again.
  const Sample s = facade_of(
      "axiom A\n A -> mirror(Half)\n Half -> columns(2m, wall, 1, Rest)\n"
      "Rest -> repeat(x, Bay, count: 2)\n Bay -> mirror(Side)\n"
      "Side -> columns(25cm, window, 1, wall)");
  ASSERT_EQ(s.said, "");
  std::vector<Rect> windows = s.rects("window");
  std::sort(windows.begin(), windows.end(), [](const Rect& a, const Rect& b) { return a.x < b.x; });
  ASSERT_EQ(windows.size(), 8u);
  const double left[] = {2, 3.75, 4, 5.75, 6, 7.75, 8, 9.75};
  for (size_t i = 0; i < 8; ++i) expect_rect(windows[i], left[i], 0, 0.25, 9);
}

TEST(Splits, GridOfCells) {
  const Sample s = facade_of("axiom A\n A -> grid(window, columns: 3, rows: 2, gap: [60cm, 1m])");
  ASSERT_EQ(s.rects("window").size(), 6u);
  expect_rect(s.rects("window")[0], 0, 0, 3.6, 4);
  expect_rect(s.rects("window")[5], 8.4, 5, 3.6, 4);
  const Sample strips = facade_of("axiom A\n A -> grid(window, spacing: [4m, 3m], size: [1m, 2m])");
  ASSERT_EQ(strips.rects("window").size(), 9u);
  expect_rect(strips.rects("window")[4], 5.5, 3.5, 1, 2);
  const Sample margins = facade_of(
      "axiom A\n A -> grid(window, columns: 3, rows: 1, size: [2m, 5m], margin: [1m, 1m, 1m, 3m])");
  expect_rect(margins.rects("window")[0], 1, 1, 2, 5);
  expect_rect(margins.rects("window")[2], 9, 1, 2, 5);
}

TEST(Splits, GridWithADoorDownToTheGround) {
  const Sample s =
      facade_of("axiom A\n A -> grid(window, door, columns: 3, rows: 2, at: 1, size: 1m)");
  ASSERT_EQ(s.rects("window").size(), 5u);
  expect_rect(s.rects("door")[0], 5.5, 0, 1, 2.75);
}

TEST(Splits, TheFourGrids) {
  // Regular: equal distances between cells. Identical: one window, derived once.
  for (const bool regular : {true, false})
    for (const bool identical : {true, false}) {
      const std::string words = std::string("regular: ") + (regular ? "true" : "false") +
                                ", identical: " + (identical ? "true" : "false");
      const Sample s =
          facade_of("axiom A\n A -> grid(window, columns: 4, rows: 3, size: 1m, " + words + ")", 3);
      ASSERT_EQ(s.rects("window").size(), 12u);
      EXPECT_EQ(s.tree.nodes.size(), identical ? 2u : 13u);
      const auto rects = s.rects("window");
      const double first = rects[1].x - rects[0].x, second = rects[2].x - rects[1].x;
      EXPECT_EQ(std::abs(first - second) < 1e-9, regular);
      size_t dx = 0;
      for (const auto& [name, value] : s.tree.nodes[0].numbers) dx += name == "dx";
      EXPECT_EQ(dx, regular ? 1u : 3u);
    }
}

TEST(Splits, InsetWithAFrame) {
  const Sample s = facade_of("axiom A\n A -> inset(1m, 2m, 3m, 10%, window, frame: wall)");
  expect_rect(s.rects("window")[0], 1, 3, 9, 5.1);
  ASSERT_EQ(s.rects("wall").size(), 4u);
  double area = 9 * 5.1;
  for (const Rect& r : s.rects("wall")) area += r.width * r.height;
  EXPECT_NEAR(area, 108, 1e-9);
}

TEST(Splits, SizesThatDoNotFitAreReported) {
  EXPECT_EQ(
      facade_of("axiom A\n A -> rows(5m, door, 6m, window)").said,
      "the parts do not fit: they need 11m of 9m ('door' 5m, 'window' 6m) (make one of them a "
      "proportion of the rest: a number without a unit)\n");
  EXPECT_EQ(facade_of("axiom A\n A -> rows(5m, door, 2m, window)").said,
            "2m of 9m is unused ('door' 5m, 'window' 2m) (make one of them a proportion of the "
            "rest: a number without a unit)\n");
  EXPECT_EQ(facade_of("axiom A\n A -> rows(9m, door, 1, window)").said,
            "nothing of 9m is left for 'window' ('door' 9m)\n");
  const Sample inner =
      facade_of("axiom A\n A -> rows(1m, B, 1, wall)\n B -> rows(2m, door, 1, wall)");
  EXPECT_NE(inner.said.find("they need 2m of 1m"), std::string::npos) << inner.said;
  EXPECT_NE(inner.said.find("while dividing B 12 x 1 m at (0, 0)"), std::string::npos)
      << inner.said;
  EXPECT_EQ(inner.where.line, 4);
  EXPECT_EQ(inner.where.column, 7);
  EXPECT_NE(facade_of("axiom A\n A -> inset(7m, window)").said.find("leave no space of 12m x 9m"),
            std::string::npos);
  EXPECT_NE(facade_of("axiom A\n A -> grid(window, columns: 3, rows: 1, size: 5m)")
                .said.find("3 columns do not fit into 12m"),
            std::string::npos);
}

TEST(Splits, InvalidArgumentsAreReported) {
  EXPECT_NE(facade_of("axiom A\n A -> rows(1m, 2m, door)").said.find("two consecutive sizes"),
            std::string::npos);
  EXPECT_NE(
      facade_of("axiom A\n A -> rows(-1m, door, 1, wall)").said.find("a size must be above 0"),
      std::string::npos);
  EXPECT_NE(facade_of("axiom A\n A -> rows(door, 1)").said.find("is not followed by a part"),
            std::string::npos);
  EXPECT_NE(facade_of("axiom A\n A -> repeat(z, 1m, door)").said.find("'z'"), std::string::npos);
  EXPECT_NE(facade_of("axiom A\n A -> repeat(x, 1e-6m, door)").said.find("would be repeated"),
            std::string::npos);
  EXPECT_NE(facade_of("axiom A\n A -> rows(30deg, door, 1, wall)").said.find("angle"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::facade
