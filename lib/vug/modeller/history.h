// States one after the other: undo, redo, checkpoints. All of them are kept, since they share what
// they have in common.
#pragma once

#include <vug/modeller/edit.h>

#include <map>
#include <string>
#include <vector>

namespace vug::modeller {

class History {
 public:
  explicit History(FacadeState start) : states_{std::move(start)} {}

  const FacadeState& now() const { return states_[done_]; }
  /// Edits that are done, then those that have been undone and can be done again.
  const std::vector<Edit>& edits() const { return edits_; }
  size_t done() const { return done_; }
  /// How many edits were done when it was set, by name.
  const std::map<std::string, size_t>& checkpoints() const { return checkpoints_; }

  /// Does one edit; what was undone before is forgotten, and so are checkpoints within that.
  /// Refused where it cannot be done, and then nothing has changed.
  void apply(const Edit& edit);
  /// Up to that many steps; how many there were.
  size_t undo(size_t steps = 1);
  size_t redo(size_t steps = 1);
  /// Gives the state of now a name; an earlier one of that name moves here. Error(bad_input)
  /// without a name.
  void set_checkpoint(const std::string& name);
  /// Undoes or does again until there. Error(bad_input) with the nearest where there is none.
  void restore(const std::string& checkpoint);

 private:
  std::vector<FacadeState> states_;  ///< One more than edits.
  std::vector<Edit> edits_;
  size_t done_ = 0;
  std::map<std::string, size_t> checkpoints_;
};

}  // namespace vug::modeller
