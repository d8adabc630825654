// SPDX-License-Identifier: Apache-2.0
// A stack of immutable document states with names, undo and redo.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace vug::workbench {

/// T is a value with cheap copies. All states are kept.
template <class T>
class UndoStack {
 public:
  explicit UndoStack(T start) : steps_{{"", "", std::move(start)}} {}

  const T& start() const { return steps_.front().state; }
  const T& current() const { return steps_[done_].state; }
  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ + 1 < steps_.size(); }
  /// Names of the steps that undo and redo affect; empty if there are none.
  const std::string& undo_name() const { return steps_[done_].name; }
  std::string redo_name() const { return can_redo() ? steps_[done_ + 1].name : ""; }
  size_t done() const { return done_; }
  /// The states that redo restores, the next one first.
  std::vector<T> undone() const {
    std::vector<T> out;
    for (size_t i = done_ + 1; i < steps_.size(); ++i) out.push_back(steps_[i].state);
    return out;
  }

  /// Whether a step with this key replaces the current one: it has the same key, which is not
  /// empty, and is not the saved state. The steps of one slider drag are one step.
  bool merges(const std::string& key) const {
    return !key.empty() && done_ > 0 && steps_[done_].merge == key && !is_clean();
  }
  /// Discards undone states and adds one, or replaces the current one.
  void push(std::string name, T state, std::string merge = "") {
    steps_.resize(done_ + 1, steps_[done_]);
    if (clean_ > static_cast<long>(done_)) clean_ = -1;
    if (merges(merge))
      steps_[done_].state = std::move(state);
    else
      steps_.push_back({std::move(name), std::move(merge), std::move(state)}), ++done_;
  }
  /// The state below the current step; the current one if there is none.
  const T& before() const { return steps_[done_ > 0 ? done_ - 1 : 0].state; }
  /// Later steps do not merge with the current one.
  void end_merge() { steps_[done_].merge.clear(); }
  /// Undo or redo up to `steps` steps; return how many.
  size_t undo(size_t steps = 1) {
    const size_t taken = std::min(steps, done_);
    done_ -= taken;
    return taken;
  }
  size_t redo(size_t steps = 1) {
    const size_t taken = std::min(steps, steps_.size() - 1 - done_);
    done_ += taken;
    return taken;
  }

  void set_clean() { clean_ = static_cast<long>(done_); }
  /// Whether the current state is the saved one.
  bool is_clean() const { return clean_ == static_cast<long>(done_); }

 private:
  struct Step {
    std::string name, merge;
    T state;
  };
  std::vector<Step> steps_;
  size_t done_ = 0;
  long clean_ = 0;  ///< Index of the saved state; -1 if it was discarded.
};

}  // namespace vug::workbench
