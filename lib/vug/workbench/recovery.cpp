// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/recovery.h>
#include <vug/workbench/words.h>

#include <algorithm>

namespace vug::workbench {

template <class Bench>
RecorderOf<Bench>::RecorderOf(Bench& bench, std::filesystem::path folder)
    : bench_(bench), folder_(std::move(folder)) {
  bench_.journal = [this](const std::string& line) {
    if (journal_) journal_->append(line);
  };
}

template <class Bench>
const CommandOf<Bench>* RecorderOf<Bench>::run(const std::string& line) {
  const CommandOf<Bench>* command = run_command(bench_, line);
  if (command && (command->opens || command->saves)) {
    if (!journal_) journal_ = std::make_unique<Journal>(folder_);
    journal_->restart({bench_.opening_line()});
  }
  return command;
}

template <class Bench>
void RecorderOf<Bench>::recover(const LostJournal& lost) {
  run_command(bench_, lost.lines.front());
  std::vector<std::string> done = {lost.lines.front()};
  // The lost journal stays until the new one contains its lines.
  const auto adopt = [&] {
    if (!journal_) journal_ = std::make_unique<Journal>(folder_);
    journal_->restart(done);
  };
  journal_.reset();
  std::error_code ignored;
  try {
    for (size_t i = 1; i < lost.lines.size(); ++i) {
      run_command(bench_, lost.lines[i]);
      done.push_back(lost.lines[i]);
    }
  } catch (const Error&) {
    adopt();
    std::filesystem::rename(lost.file, rejected_file(lost), ignored);
    throw;
  }
  adopt();
  std::filesystem::remove(lost.file, ignored);
}

template <class Bench>
bool RecorderOf<Bench>::is_open_elsewhere() const {
  if (!journal_) return false;
  const auto document = [](const std::string& line) {
    const std::vector<std::string> words = split_words(line);
    return words.size() > 1 ? words[1] : std::string();
  };
  const std::string own = document(bench_.opening_line());
  const std::vector<std::string> lines = held_opening_lines(folder_, journal_->file());
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return document(line) == own; });
}

template class RecorderOf<FacadeBench>;
template class RecorderOf<SceneBench>;

bool is_scene_journal(const LostJournal& lost) {
  const std::vector<std::string> words = split_words(lost.lines.front());
  return words.size() > 1 && std::filesystem::path(words[1]).extension() == ".vug";
}

std::filesystem::path rejected_file(const LostJournal& lost) {
  return std::filesystem::path(lost.file).concat(".rejected");
}

}  // namespace vug::workbench
