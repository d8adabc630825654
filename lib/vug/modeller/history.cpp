// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/history.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::modeller {

void History::apply(const Edit& edit) {
  FacadeState next = perform_edit(current(), edit);
  const auto keep = static_cast<std::ptrdiff_t>(done_);
  states_.erase(states_.begin() + keep + 1, states_.end());
  edits_.erase(edits_.begin() + keep, edits_.end());
  std::erase_if(checkpoints_, [&](const auto& each) { return each.second > done_; });
  states_.push_back(std::move(next));
  edits_.push_back(edit);
  ++done_;
}

size_t History::undo(size_t steps) {
  const size_t taken = std::min(steps, done_);
  done_ -= taken;
  return taken;
}

size_t History::redo(size_t steps) {
  const size_t taken = std::min(steps, edits_.size() - done_);
  done_ += taken;
  return taken;
}

void History::set_checkpoint(const std::string& name) {
  if (name.empty()) throw Error(ErrorCode::bad_input, "a checkpoint needs a name");
  checkpoints_[name] = done_;
}

void History::restore(const std::string& checkpoint) {
  const auto found = checkpoints_.find(checkpoint);
  std::vector<std::string> names;
  for (const auto& [name, at] : checkpoints_) names.push_back(name);
  if (found == checkpoints_.end())
    throw Error(ErrorCode::bad_input, fmt::format("unknown checkpoint '{}'", checkpoint), {},
                suggestion(checkpoint, names));
  done_ = found->second;
}

}  // namespace vug::modeller
