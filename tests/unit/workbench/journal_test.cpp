// SPDX-License-Identifier: Apache-2.0
// Recovery of a bench from the journal of a program that was killed.
#include "bench.h"

#include <vug/base/atomic_file.h>
#include <vug/base/rng.h>
#include <vug/workbench/journal.h>
#include <vug/workbench/recovery.h>

#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

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

/// A script of 200 commands.
std::vector<std::string> script() {
  std::vector<std::string> out = {"photo " + paris_photo() + " 15m",
                                  "apply 0 rows heights=3.6",
                                  "act 0.1 mirror(SymmetricFacadeSide) width=5",
                                  "act 0.1.0 IdenticalGrid columns=2 rows=5",
                                  "select 0.1.0",
                                  "act 0.1.1 Grid"};
  RandomStream stream{RandomKey(3)};
  for (size_t i = out.size(); i < 200; ++i) {
    const uint32_t which = stream.below(5);
    if (which == 0 && i > 10)
      out.push_back("undo");
    else if (which == 1)
      out.push_back("adjust 0.1.0.0 rows=" + std::to_string(2 + stream.below(4)));
    else
      out.push_back("set 0.1 width=" + std::to_string(2 + stream.below(5)));
  }
  return out;
}

/// Writes the first lines and a part of the next one to a journal in the folder, and is killed.
void write_and_be_killed(const std::filesystem::path& folder, const std::vector<std::string>& lines,
                         size_t kept) {
  const pid_t child = ::fork();
  if (child == 0) {
    Journal journal(folder);
    journal.restart({lines.begin(), lines.begin() + static_cast<long>(kept) - 1});
    journal.append(lines[kept - 1]);
    if (kept < lines.size())
      std::ofstream(journal.file(), std::ios::app) << lines[kept].substr(0, 4);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(JournalRecovery, GivesTheLastStateAfterAKillAtAnyOfFiftyPoints) {
  const std::vector<std::string> lines = script();
  std::set<size_t> points = {2, lines.size()};
  RandomStream stream{RandomKey(8)};
  while (points.size() < 50)
    points.insert(2 + stream.below(static_cast<uint32_t>(lines.size() - 2)));
  FacadeBench expected;
  size_t done = 0;
  for (const size_t kept : points) {
    while (done < kept) run_command(expected, lines[done++]);
    const ScratchFolder folder("vug_journal");
    write_and_be_killed(folder.path(), lines, kept);
    const std::vector<LostJournal> lost = lost_journals(folder.path());
    ASSERT_EQ(lost.size(), 1u);
    ASSERT_EQ(lost[0].lines.size(), kept);
    FacadeBench recovered;
    Recorder recorder(recovered, folder.file("new"));
    recorder.recover(lost[0]);
    EXPECT_EQ(text_of(recovered), text_of(expected)) << kept;
    EXPECT_EQ(recovered.stack().done(), expected.stack().done()) << kept;
    EXPECT_TRUE(lost_journals(folder.path()).empty()) << "it is used once";
  }
}

/// A lost journal with these lines in the folder.
LostJournal lost_journal(const ScratchFolder& folder, const std::string& text) {
  write_text(folder.file("1-0.vugjournal"), text);
  return lost_journals(folder.path()).at(0);
}

TEST(JournalRecovery, KeepsTheJournalWhosePhotoIsMissing) {
  const ScratchFolder folder("vug_journal");
  FacadeBench bench;
  Recorder recorder(bench, folder.file("new"));
  recorder.run("photo " + paris_photo() + " 15m");
  recorder.run("act 0 Grid");
  const std::string before = text_of(bench);
  const LostJournal lost = lost_journal(folder, "photo moved.jpg 15m\nact 0 Grid\n");
  EXPECT_THROW(recorder.recover(lost), Error);
  EXPECT_EQ(lost_journals(folder.path()).size(), 1u) << "it can be recovered later";
  EXPECT_EQ(text_of(bench), before);
  recorder.run("undo");
  EXPECT_NE(text_of(bench), before);
}

TEST(JournalRecovery, PutsAJournalWithAnInvalidLineAside) {
  const ScratchFolder folder("vug_journal");
  FacadeBench bench;
  Recorder recorder(bench, folder.file("new"));
  const LostJournal lost =
      lost_journal(folder, "photo " + paris_photo() + " 15m\nact 0 Grid\nact 9 Grid\nundo\n");
  EXPECT_THROW(recorder.recover(lost), Error);
  EXPECT_EQ(bench.stack().done(), 1u) << "the lines before it are in effect";
  EXPECT_TRUE(lost_journals(folder.path()).empty()) << "it is offered once";
  EXPECT_NE(read_text(rejected_file(lost)).find("undo"), std::string::npos) << "nothing is lost";
}

TEST(Recorder, BeginsItsJournalAgainWithEachFile) {
  const ScratchFolder folder("vug_journal");
  FacadeBench bench;
  Recorder recorder(bench, folder.file("state"));
  const auto text = [&] {
    std::string out;
    for (const auto& each : std::filesystem::directory_iterator(folder.file("state")))
      out += read_text(each.path());
    return out;
  };
  recorder.run("photo " + paris_photo() + " 15m");
  recorder.run("act 0 Grid");
  EXPECT_NE(text().find("15m ripperda.vug\nact 0 Grid\n"), std::string::npos) << text();
  const std::string file = folder.file("saved.json").string();
  recorder.run("save " + file);
  recorder.run("undo");
  EXPECT_EQ(text(), "open " + file + "\nundo\n");
}

}  // namespace
}  // namespace vug::workbench
