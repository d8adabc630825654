// SPDX-License-Identifier: Apache-2.0
// A bench that records its commands in a journal, and continues journals of killed programs.
#pragma once

#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/journal.h>
#include <vug/workbench/scene_bench.h>
#include <vug/workbench/scene_command.h>

namespace vug::workbench {

/// Keeps the journal of a bench up to date. Both must outlive it or end with it. Bench: FacadeBench
/// or SceneBench.
template <class Bench>
class RecorderOf {
 public:
  RecorderOf(Bench& bench, std::filesystem::path folder);

  /// Runs a command line and records it if it changes the document. Errors are those of
  /// run_command, and so is the result.
  const CommandOf<Bench>* run(const std::string& line);
  /// Runs the lines of a lost journal, which is then removed. If the first line, which opens the
  /// document, fails (a photo was moved), its error is thrown, and neither the bench nor the lost
  /// journal changes. Any later line that fails ends the recovery with its error: the lines before
  /// it are in effect, and the lost journal is renamed to `rejected_file`.
  void recover(const LostJournal& lost);
  const std::filesystem::path& folder() const { return folder_; }
  /// Whether another window has the file of this document open.
  bool is_open_elsewhere() const;

 private:
  Bench& bench_;
  std::filesystem::path folder_;
  std::unique_ptr<Journal> journal_;
};
using Recorder = RecorderOf<FacadeBench>;
using SceneRecorder = RecorderOf<SceneBench>;

/// Whether the journal is that of a scene text, not of a facade.
bool is_scene_journal(const LostJournal& lost);

/// Where a lost journal with an invalid line is kept; no program offers this file.
std::filesystem::path rejected_file(const LostJournal& lost);

}  // namespace vug::workbench
