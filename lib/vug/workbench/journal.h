// SPDX-License-Identifier: Apache-2.0
// A journal of the commands of a session, from which a killed program recovers its work.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vug::workbench {

/// A file with one command a line. Each line is on the disk when `append` returns. While a journal
/// exists, its file is locked, so that another window does not recover it.
class Journal {
 public:
  /// Creates a file of a new name in the folder, which is created if it is missing. Error(io).
  explicit Journal(const std::filesystem::path& folder);
  /// Removes the file: the document was closed.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  const std::filesystem::path& file() const { return file_; }
  /// Replaces all lines, e.g. by the one that opens the saved document.
  void restart(const std::vector<std::string>& lines);
  void append(const std::string& line);

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

struct LostJournal {
  std::filesystem::path file;
  std::vector<std::string> lines;
};
/// The journals in a folder that no program holds and that contain more than the line that opens
/// their document; the newest one first. A last line that was not written completely is omitted.
std::vector<LostJournal> lost_journals(const std::filesystem::path& folder);

/// The first lines of the journals in a folder that running programs hold, except for `own`.
std::vector<std::string> held_opening_lines(const std::filesystem::path& folder,
                                            const std::filesystem::path& own);

/// The user's folder for journals: $VUG_STATE_HOME, else vug below $XDG_STATE_HOME or
/// ~/.local/state.
std::filesystem::path journal_folder();

}  // namespace vug::workbench
