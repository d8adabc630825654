// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/recovery.h>
#include <vug/workbench/words.h>

namespace vug::workbench {

Recorder::Recorder(FacadeBench& bench, std::filesystem::path folder)
    : bench_(bench), folder_(std::move(folder)) {
  bench_.journal = [this](const std::string& line) {
    if (journal_) journal_->append(line);
  };
}

void Recorder::run(const std::string& line) {
  run_command(bench_, line);
  const std::vector<std::string> words = split_words(line);
  if (words.empty() || !find_command(words.front()).opens) return;
  if (!journal_) journal_ = std::make_unique<Journal>(folder_);
  journal_->restart({bench_.opening_line()});
}

void Recorder::recover(const LostJournal& lost) {
  // The lost journal stays until the new one contains its lines.
  journal_.reset();
  std::vector<std::string> done;
  const auto adopt = [&] {
    if (!done.empty()) {
      journal_ = std::make_unique<Journal>(folder_);
      journal_->restart(done);
    }
    std::error_code ignored;
    std::filesystem::remove(lost.file, ignored);
  };
  try {
    for (const std::string& line : lost.lines) {
      run_command(bench_, line);
      done.push_back(line);
    }
  } catch (const Error&) {
    adopt();
    throw;
  }
  adopt();
}

}  // namespace vug::workbench
