// SPDX-License-Identifier: Apache-2.0
// Recovery of a bench from the journal of a program that was killed.
#include "bench.h"

#include <vug/base/atomic_file.h>
#include <vug/workbench/journal.h>

#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <filesystem>

namespace vug::workbench {
namespace {

TEST(Journal, OfARunningProgramIsNotOffered) {
  const ScratchFolder folder("vug_journal");
  Journal journal(folder.path());
  journal.restart({"open a.json"});
  journal.append("undo");
  EXPECT_TRUE(lost_journals(folder.path()).empty());
  EXPECT_EQ(read_text(journal.file()), "open a.json\nundo\n");
}

TEST(Journal, DisappearsWithTheDocument) {
  const ScratchFolder folder("vug_journal");
  { Journal journal(folder.path()); }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Journal, OmitsTheLineThatWasNotCompleted) {
  const ScratchFolder folder("vug_journal");
  write_text(folder.file("1-0.vugjournal"), "open a.json\nundo\nredo\nact 0 Gr");
  write_text(folder.file("2-0.vugjournal"), "open a.json\n");
  const std::vector<LostJournal> lost = lost_journals(folder.path());
  ASSERT_EQ(lost.size(), 1u) << "a journal without edits has nothing to recover";
  EXPECT_EQ(lost[0].lines, (std::vector<std::string>{"open a.json", "undo", "redo"}));
}

std::vector<std::string> script() {
  std::vector<std::string> out = {"photo " + paris_photo() + " 15m",
                                  "apply 0 rows heights=3.6",
                                  "act 0.1 mirror(SymmetricFacadeSide, SymmetricFacadeMiddle)",
                                  "act 0.1.0 IdenticalGrid columns=2 rows=5",
                                  "select 0.1.0",
                                  "act 0.1.1 Grid"};
  for (int i = 0; i < 8; ++i)
    out.push_back(i % 3 == 2 ? "undo" : "set 0.1 width=" + std::to_string(3 + i % 2));
  return out;
}

TEST(Journal, RecoversTheStateOfAKilledProgram) {
  const std::vector<std::string> lines = script();
  for (size_t kept = 2; kept <= lines.size(); kept += 3) {
    const ScratchFolder folder("vug_journal");
    const pid_t child = ::fork();
    if (child == 0) {
      Journal journal(folder.path());
      for (size_t i = 0; i < kept; ++i) journal.append(lines[i]);
      ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    const std::vector<LostJournal> lost = lost_journals(folder.path());
    ASSERT_EQ(lost.size(), 1u);
    FacadeBench recovered, expected;
    run(recovered, lost[0].lines);
    run(expected, {lines.begin(), lines.begin() + static_cast<long>(kept)});
    EXPECT_EQ(text_of(recovered), text_of(expected));
    EXPECT_EQ(recovered.stack().done(), expected.stack().done());
  }
}

}  // namespace
}  // namespace vug::workbench
