// SPDX-License-Identifier: Apache-2.0
// Changes of texts in whole characters, and the conventions of files.
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/workbench/scene_text.h>

#include <gtest/gtest.h>

namespace vug::workbench {
namespace {

TEST(SceneText, TheSmallestChangeIsFound) {
  const TextChange insertion = change_between("param A = 3\n", "param A = 43\n");
  EXPECT_EQ(insertion.begin, 10u);
  EXPECT_EQ(insertion.removed, 0u);
  EXPECT_EQ(insertion.text, "4");
  EXPECT_TRUE(change_between("abc", "abc").empty());
  const TextChange repeated = change_between("aaa", "aa");
  EXPECT_EQ(repeated.removed, 1u);
  EXPECT_EQ(with_change("aaa", repeated), "aa");
}

TEST(SceneText, ChangesContainWholeCharacters) {
  // The characters differ in their last byte only.
  const TextChange change = change_between("x\u00e4y", "x\u00e5y");
  EXPECT_EQ(change.text, "\u00e5");
  EXPECT_EQ(change.removed, 2u);
  EXPECT_THROW(with_change("x\u00e4y", {2, 0, "z"}), Error);
  EXPECT_THROW(with_change("abc", {2, 2, ""}), Error);
  EXPECT_THROW(with_change("abc", {4, 0, ""}), Error);
}

TEST(SceneText, AChangeLeadsToTheOtherText) {
  RandomStream random{RandomKey(5)};
  const std::string alphabet[] = {"a", "b", "\n", "\u00e4", "\u20ac", "\U0001d6d1"};
  const auto text = [&] {
    std::string out;
    for (uint32_t k = random.below(12); k > 0; --k) out += alphabet[random.below(6)];
    return out;
  };
  for (int i = 0; i < 2000; ++i) {
    const std::string a = text(), b = text();
    ASSERT_EQ(with_change(a, change_between(a, b)), b) << a << " -> " << b;
  }
}

TEST(SceneText, FilesKeepTheirConventions) {
  const FileConventions windows = conventions_of("\xef\xbb\xbf# a\r\n# b\r\n");
  EXPECT_EQ(with_conventions("# a\n# b\n", windows), "\xef\xbb\xbf# a\r\n# b\r\n");
  EXPECT_EQ(with_conventions("# a\n", conventions_of("# b\n")), "# a\n");
}

}  // namespace
}  // namespace vug::workbench
