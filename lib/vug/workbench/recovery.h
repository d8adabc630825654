// SPDX-License-Identifier: Apache-2.0
// A facade bench that records its commands in a journal, and continues journals of killed programs.
#pragma once

#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/journal.h>

namespace vug::workbench {

/// Keeps the journal of a bench up to date. Both must outlive it or end with it.
class Recorder {
 public:
  Recorder(FacadeBench& bench, std::filesystem::path folder);

  /// Runs a command line and records it if it changes the document. Errors are those of
  /// run_command, and so is the result.
  const Command* run(const std::string& line);
  /// Runs the lines of a lost journal, which is removed. An invalid line ends it with its error,
  /// after which the lines before it are in effect.
  void recover(const LostJournal& lost);
  const std::filesystem::path& folder() const { return folder_; }

 private:
  FacadeBench& bench_;
  std::filesystem::path folder_;
  std::unique_ptr<Journal> journal_;
};

}  // namespace vug::workbench
