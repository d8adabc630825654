// SPDX-License-Identifier: Apache-2.0
#include "derived.h"

#include <cmath>

namespace vug::facade {
namespace {

TEST(Tree, ThetaOfThePublishedFigure2) {
  const Sample s = facade_of(
      "axiom Facade\n"
      "Facade -> mirror(SymmetricFacadeSide, 4m, SymmetricFacadeMiddle)\n"
      "SymmetricFacadeSide -> RegularGrid\n"
      "SymmetricFacadeMiddle -> RegularIdenticalGrid\n"
      "RegularGrid -> grid(window, columns: 1, rows: 2, size: 2m, identical: false)\n"
      "RegularIdenticalGrid -> grid(window, door, columns: 1, rows: 2, size: 2m)",
      0, 12, 8);
  EXPECT_EQ(theta(s.tree),
            "Facade(0, 0, 12, 8, (SymmetricFacadeSide(RegularGrid(1, 2, 1, 1, 0, 4, (window(2, 2, "
            "1, 1), window(2, 2, 1, 5)))), SymmetricFacadeMiddle(4, RegularIdenticalGrid(1, 2, 1, "
            "1, 0, 4, (window(2, 2, 5, 5), door(2, 3, 5, 0))))))");
}

TEST(Tree, OccurrencesOfCopiesOfCopies) {
  const Sample s = facade_of(
      "axiom A\n A -> mirror(B)\n B -> repeat(x, C, count: 3)\n C -> grid(window, columns: 2, "
      "rows: 2)");
  EXPECT_EQ(occurrences(s.tree), (std::vector<double>{1, 2, 6, 24}));
  EXPECT_EQ(placements(s.tree, 3).size(), 24u);
  EXPECT_EQ(placements(s.tree, 3)[0], Placement{});
  EXPECT_EQ(element_instances(s.tree).size(), 24u);
}

TEST(Tree, TooManyElementsAreRejected) {
  const Sample s =
      facade_of("axiom A\n A -> repeat(x, B, count: 2000)\n B -> repeat(y, window, count: 2000)");
  EXPECT_EQ(occurrences(s.tree)[2], 4e6);
  EXPECT_THROW(element_instances(s.tree), Error);
}

TEST(Tree, PlacementsCompose) {
  const Rect r{1, 2, 3, 4};
  const Placement a = Placement::mirror(6), b = Placement::shift(2, 1);
  expect_rect(a.after(b)(r), a(b(r)).x, a(b(r)).y, 3, 4);
  expect_rect(b.after(a)(r), b(a(r)).x, b(a(r)).y, 3, 4);
  expect_rect(a.after(a)(r), 1, 2, 3, 4);
}

TEST(Tree, DrawingsHaveTooltips) {
  const Sample s = facade_of("axiom A\n A -> columns(1, window, 1, door)");
  const std::string svg = elevation_svg(s.tree, {.picture = "a&b.png"});
  EXPECT_NE(svg.find("href=\"a&amp;b.png\""), std::string::npos);
  EXPECT_NE(svg.find("<title>door 6 x 9 m</title>"), std::string::npos);
  EXPECT_NE(svg.find("A -&gt; columns(window, door)</title>"), std::string::npos);
  EXPECT_EQ(elements_csv(s.tree),
            "kind,x,y,width,height,mirrored\nwindow,0,0,6,9,0\ndoor,6,0,6,9,0\n");
}

}  // namespace
}  // namespace vug::facade
