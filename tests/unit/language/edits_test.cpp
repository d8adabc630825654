// SPDX-License-Identifier: Apache-2.0
// Edits that keep the formatting.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/language/edits.h>

namespace vug::language {
namespace {

std::string with_argument(const std::string& marked, const std::string& name,
                          const std::string& value) {
  const MarkedText text(marked);
  return apply(text.text, {set_argument(*text.analysis, text.position, name, value)});
}

TEST(Edits, AnArgumentIsReplacedOrAdded) {
  EXPECT_EQ(with_argument("let a = sphere(|radius: 1m)  # big\n", "radius", "3m"),
            "let a = sphere(radius: 3m)  # big\n");
  EXPECT_EQ(with_argument("let a = torus(1m|, 20cm)\n", "radius", "2m"),
            "let a = torus(2m, 20cm)\n");
  EXPECT_EQ(with_argument("let a = box(|)\n", "size", "(1, 2, 3)"),
            "let a = box(size: (1, 2, 3))\n");
  EXPECT_EQ(with_argument("let a = torus(\n  radius: 1m,  # of the ring\n  tub|e: (2cm)\n)\n",
                          "center", "(0, 0, 0)"),
            "let a = torus(\n  radius: 1m,  # of the ring\n  tube: (2cm), center: (0, 0, 0)\n)\n");
  EXPECT_EQ(with_argument("let a = sphere(1m).translate(|)\n", "by", "(1, 0, 0)"),
            "let a = sphere(1m).translate(by: (1, 0, 0))\n");
}

TEST(Edits, AParamIsReplacedWithoutItsRangeAndDescription) {
  const MarkedText text("# Size.\nparam  a = 2 * (1cm + 3cm)  in 1cm..9cm \"edge\"  # note\n");
  EXPECT_EQ(apply(text.text, {set_param(*text.analysis, "a", "4cm")}),
            "# Size.\nparam  a = 4cm  in 1cm..9cm \"edge\"  # note\n");
  EXPECT_THROW(set_param(*text.analysis, "b", "4cm"), Error);
}

TEST(Edits, AnEntryIsReplacedOrAdded) {
  const MarkedText text("camera c {\n  eye (0, 0, 3)  # far\n  fov 40deg\n}\nrender r { spp 4 }\n");
  const Analysis& analysis = *text.analysis;
  EXPECT_EQ(apply(text.text, {set_entry(analysis, "camera", "c", "fov", "50deg")}),
            "camera c {\n  eye (0, 0, 3)  # far\n  fov 50deg\n}\nrender r { spp 4 }\n");
  EXPECT_EQ(apply(text.text, {set_entry(analysis, "camera", "c", "target", "(0, 1, 0)"),
                              set_entry(analysis, "render", "r", "size", "64x64")}),
            "camera c {\n  eye (0, 0, 3)  # far\n  fov 40deg\n  target (0, 1, 0)\n}\n"
            "render r { spp 4  size 64x64 }\n");
  EXPECT_THROW(set_entry(analysis, "camera", "d", "fov", "50deg"), Error);
}

TEST(Edits, EachParamOfEachSceneCanBeSetAndSetBack) {
  int edits = 0;
  for (const auto& scene : data_scenes()) {
    Workspace workspace(with_data());
    const AnalysisPtr text = workspace.analyse(scene);
    if (text->diagnostics.has_errors()) continue;
    for (const scene::Param& param : text->document.params) {
      if (param.where.file != text->file) continue;
      const std::string before(scene::text_at(text->text, param.value->extent));
      workspace.open(scene, apply(text->text, {set_param(*text, param.name, "(1 + 2)")}));
      const AnalysisPtr changed = workspace.analyse(scene);
      EXPECT_EQ(changed->document.find_param(param.name)->doc, param.doc);
      EXPECT_EQ(changed->text.size() - text->text.size(), 7 - before.size());
      workspace.close(scene);
      ++edits;
    }
  }
  EXPECT_GT(edits, 100);
}

TEST(Edits, BytesHavePositions) {
  const std::string text = "a\u00e4\n\n\u20acb";
  for (size_t byte = 0; byte <= text.size(); ++byte) {
    const Position at = position_at(text, byte);
    EXPECT_LE(scene::byte_at(text, at.line, at.column), byte);
    if (byte < text.size() && (text[byte] & 0xc0) == 0x80) continue;
    EXPECT_EQ(scene::byte_at(text, at.line, at.column), byte);
  }
  EXPECT_EQ(position_at(text, text.size()), (Position{3, 3}));
}

TEST(Edits, InsertionsAtOnePositionKeepTheirOrder) {
  const SourceLocation at = range_at("", {1, 2});
  EXPECT_EQ(apply("ab\n", {{at, "1"}, {at, "2"}, {range_between("", {1, 2}, {1, 3}), "c"}}),
            "a12c\n");
}

}  // namespace
}  // namespace vug::language
