// SPDX-License-Identifier: Apache-2.0
// Names of `where` in the rules of facades.
#include "derived.h"

namespace vug::facade {
namespace {

void expect_same(const Sample& a, const Sample& b) {
  ASSERT_EQ(a.said + b.said, "");
  const std::vector<Rect> first = a.rects("window"), second = b.rects("window");
  ASSERT_EQ(first.size(), second.size());
  for (size_t i = 0; i < first.size(); ++i)
    expect_rect(first[i], second[i].x, second[i].y, second[i].width, second[i].height);
}

TEST(Locals, NameSizesAndPartsOfARule) {
  const Sample named = facade_of(
      "axiom Facade(2)\n"
      "Facade(n) if tall -> rows(base, wall, 1, grid(pane, columns: n, rows: n + 1, gap: 50cm))\n"
      "    where tall = height > base * 2, pane = window(sash: edge), edge = 5cm * n, base = n * "
      "1m\n"
      "Facade(n) if height <= n * 2m -> wall");
  const Sample plain = facade_of(
      "axiom Facade(2)\n"
      "Facade(n) if height > n * 1m * 2 -> rows(n * 1m, wall, 1,\n"
      "    grid(window(sash: 5cm * n), columns: n, rows: n + 1, gap: 50cm))\n"
      "Facade(n) if height <= n * 2m -> wall");
  expect_same(named, plain);
  EXPECT_EQ(named.rects("window").size(), 6u);
}

TEST(Locals, LoopVariablesHideThem) {
  const Sample named = facade_of(
      "axiom Facade(2)\n"
      "Facade(i) -> columns(all[0], window, all[1], window, 1, wall)\n"
      "    where unit = i * 1m, all = [for i in 1..2: i * unit]");
  const Sample plain =
      facade_of("axiom Facade\nFacade -> columns(2m, window, 4m, window, 1, wall)");
  expect_same(named, plain);
}

}  // namespace
}  // namespace vug::facade
