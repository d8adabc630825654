// SPDX-License-Identifier: Apache-2.0
// The table of commands and the queries of scripts.
#include "bench.h"

#include <set>

namespace vug::workbench {
namespace {

TEST(Commands, HaveDocumentationAndNoSharedKeys) {
  std::set<std::string> names, keys;
  for (const Command* each : all_commands()) {
    EXPECT_TRUE(names.insert(each->name).second) << each->name;
    EXPECT_NE(each->title, "");
    EXPECT_NE(each->doc, "") << each->name;
    if (each->keys.empty()) continue;
    EXPECT_TRUE(keys.insert(each->keys).second) << each->name;
  }
  for (const modeller::EditKind* kind : modeller::edit_kinds())
    EXPECT_TRUE(names.count(kind->name)) << kind->name;
}

TEST(Commands, RefuseWithAReason) {
  FacadeBench bench;
  EXPECT_EQ(refusal(bench, "undo"), "'undo' is not available: no facade is open");
  EXPECT_EQ(refusal(bench, "undoo"), "unknown command 'undoo'");
  EXPECT_NE(refusal(bench, "open"), "");
  run(bench, {"photo " + paris_photo() + " 15m"});
  EXPECT_EQ(refusal(bench, "undo"), "'undo' is not available: there is nothing to undo");
  EXPECT_EQ(refusal(bench, "nudge 10cm"), "'nudge' is not available: no handle is selected");
  EXPECT_NE(refusal(bench, "act 0 Grdi"), "");
  EXPECT_EQ(bench.document().edit_count(), 0u);
}

TEST(Commands, AreJournalledIfTheyChangeTheDocument) {
  FacadeBench bench;
  std::vector<std::string> lines;
  bench.journal = [&](const std::string& line) { lines.push_back(line); };
  run(bench, {"photo " + paris_photo() + " 15m", "zoom 2 10 10", "act 0 Grid", "undo"});
  EXPECT_EQ(refusal(bench, "act 0 Unknown").empty(), false);
  EXPECT_EQ(lines, (std::vector<std::string>{"act 0 Grid", "undo"}));
}

TEST(Queries, AreAssertions) {
  FacadeBench bench;
  run(bench, {"photo " + paris_photo() + " 15m"});
  EXPECT_NO_THROW(expect(bench, {"edits", "=", "0"}));
  EXPECT_NO_THROW(expect(bench, {"edits", "below", "1"}));
  EXPECT_NO_THROW(expect(bench, {"size", "=", "15 x 19.75"}));
  EXPECT_NO_THROW(expect(bench, {"reason", "Grid", "=", ""}));
  run(bench, {"act 0 Grid"});
  EXPECT_NO_THROW(expect(bench, {"reason", "Grid", "contains", "divided already"}));
  EXPECT_NO_THROW(expect(bench, {"undo_name", "=", "Apply Grid to Facade"}));
  EXPECT_THROW(expect(bench, {"edits", "=", "4"}), Error);
  EXPECT_THROW(expect(bench, {"edits", "like", "4"}), Error);
  EXPECT_THROW(expect(bench, {"edit", "=", "4"}), Error);
  for (const Query* each : queries()) EXPECT_NE(each->doc, "") << each->name;
}

}  // namespace
}  // namespace vug::workbench
