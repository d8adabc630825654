// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/base/atomic_file.h>
#include <vug/grammar/tree_output.h>

#include <gtest/gtest.h>

namespace vug::grammar {
namespace {

Tree tiny() {
  Grammar g;
  g.name = "cave";
  g.axiom = {part("Room", 2), part("Lost")};
  g.productions = {
      rule("Room", {computed("hall", [](const RewriteSite& s) { return s.depth + 0.5; })}),
      rule("Lost", {})};
  g.productions[0].where = {"tiny.vug", 3, 1};
  g.productions[0].name = "Room -> hall & <door>";
  g.productions[0].successor[0].terminal = true;
  g.productions[1].guard = [](const RewriteSite&) { return false; };
  return derive(g, RandomKey(2012));
}

TEST(TreeText, Golden) {
  EXPECT_EQ(tree_text(tiny()),
            "cave\n"
            "├─ Room  ⟵ Room -> hall & <door> (tiny.vug:3:1)\n"
            "│  └─ hall(1.5)\n"
            "├─ Room  ⟵ Room -> hall & <door> (tiny.vug:3:1)\n"
            "│  └─ hall(1.5)\n"
            "└─ Lost  (no production applies)\n");
  TextOptions bare;
  bare.provenance = false;
  EXPECT_EQ(tree_text(tiny(), bare).substr(0, 25), "cave\n├─ Room\n│  └");
}

TEST(TreeJson, ContainsProvenance) {
  const std::string json = tree_json(tiny());
  for (const char* piece :
       {"\"applied\": 2", "\"path\": \"cave/Room[1]/hall[0]\"", "\"text\": \"hall(1.5)\"",
        "\"production\": 0", "\"stuck\": true", "\"terminal\": true", "\"line\": 3"})
    EXPECT_NE(json.find(piece), std::string::npos) << piece;
  EXPECT_EQ(json, tree_json(tiny()));
}

TEST(TreeJson, AcceptsInvalidUtf8) {
  Grammar g;
  g.axiom = {terminal("bad\xff")};
  EXPECT_NE(tree_json(derive(g, RandomKey(1))).find("bad"), std::string::npos);
}

TEST(TreeSvg, Golden) {
  const std::string svg = tree_svg(tiny());
  EXPECT_EQ(svg, read_text(std::string(VUG_TEST_DATA) + "/grammar/tiny.svg"));
}

TEST(TreeSvg, CutsLongLabelsAtCharacters) {
  Grammar g;
  g.axiom = {terminal("ééééééé")};
  SvgOptions options;
  options.max_label = 4;
  EXPECT_NE(tree_svg(derive(g, RandomKey(1)), options).find(">ééé…<"), std::string::npos);
  options.max_label = 7;
  EXPECT_NE(tree_svg(derive(g, RandomKey(1)), options).find(">ééééééé<"), std::string::npos);
}

}  // namespace
}  // namespace vug::grammar
