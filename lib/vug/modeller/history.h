// SPDX-License-Identifier: Apache-2.0
// A history of states with undo, redo and checkpoints. All states are kept, since they share
// unchanged data.
#pragma once

#include <vug/modeller/edit.h>

#include <map>
#include <string>
#include <vector>

namespace vug::modeller {

class History {
 public:
  explicit History(FacadeState start) : states_{std::move(start)} {}

  const FacadeState& current() const { return states_[done_]; }
  /// The edits that are in effect, followed by undone edits that can be redone.
  const std::vector<Edit>& edits() const { return edits_; }
  size_t done() const { return done_; }
  /// Number of edits in effect when each checkpoint was set, by name.
  const std::map<std::string, size_t>& checkpoints() const { return checkpoints_; }

  /// Performs an edit and discards undone edits and the checkpoints among them. Throws RejectedEdit
  /// if the edit cannot be performed; the history is then unchanged.
  void apply(const Edit& edit);
  /// Undoes or redoes up to `steps` edits; returns how many.
  size_t undo(size_t steps = 1);
  size_t redo(size_t steps = 1);
  /// Names the current state; an existing checkpoint of that name moves here. Error(bad_input) for
  /// an empty name.
  void set_checkpoint(const std::string& name);
  /// Undoes or redoes edits until the checkpoint. Error(bad_input) with the nearest name if it does
  /// not exist.
  void restore(const std::string& checkpoint);

 private:
  std::vector<FacadeState> states_;  ///< One more than edits.
  std::vector<Edit> edits_;
  size_t done_ = 0;
  std::map<std::string, size_t> checkpoints_;
};

}  // namespace vug::modeller
