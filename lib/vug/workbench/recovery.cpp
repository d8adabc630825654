// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/recovery.h>

namespace vug::workbench {

Recorder::Recorder(FacadeBench& bench, std::filesystem::path folder)
    : bench_(bench), folder_(std::move(folder)) {
  bench_.journal = [this](const std::string& line) {
    if (journal_) journal_->append(line);
  };
}

const Command* Recorder::run(const std::string& line) {
  const Command* command = run_command(bench_, line);
  if (command && command->opens) {
    if (!journal_) journal_ = std::make_unique<Journal>(folder_);
    journal_->restart({bench_.opening_line()});
  }
  return command;
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
