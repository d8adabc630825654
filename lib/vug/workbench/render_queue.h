// SPDX-License-Identifier: Apache-2.0
// Renders that wait for one another, each by a process of `vug render`. The queue is kept in a
// file, so that another session continues it; the owner of the processes reports what they do.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vug::workbench {

enum class RenderState {
  waiting,
  running,
  paused,  ///< Its checkpoint has the work so far.
  done,
  failed,
  cancelled,  ///< It is removed when its process has ended.
};
/// "waiting", "running", ... in the order of the enumeration.
const std::vector<std::string>& render_state_names();

struct QueuedRender {
  int number = 0;  ///< From 1.
  std::filesystem::path scene;
  std::string render;                   ///< Name of the render block; empty: the only one.
  std::vector<std::string> parameters;  ///< "NAME=VALUE", as for `-D`.
  std::filesystem::path output;         ///< An .exr
  RenderState state = RenderState::waiting;
  std::string stage;    ///< The stage of the program.
  double fraction = 0;  ///< Finished share of the stage, 0..1.
  std::string error;    ///< The messages of a program that failed.

  std::filesystem::path checkpoint() const;
  /// The arguments of `vug`.
  std::vector<std::string> arguments() const;
};

/// Used by one thread. Functions throw Error(bad_input) for an unknown number.
class RenderQueue {
 public:
  /// Reads the queue in the folder. What was running when its program ended is paused. Only one
  /// queue at a time can change it; see `is_held_elsewhere`.
  explicit RenderQueue(const std::filesystem::path& folder);
  ~RenderQueue();
  RenderQueue(const RenderQueue&) = delete;
  RenderQueue& operator=(const RenderQueue&) = delete;

  /// Whether another window owns the queue; then this one is empty and refuses renders.
  bool is_held_elsewhere() const { return lock_ < 0; }
  const std::vector<QueuedRender>& all() const { return all_; }
  const QueuedRender& find(int number) const;
  /// Increases with each change.
  uint64_t revision() const { return revision_; }

  /// Adds a render at the end and returns its number. Error(bad_input) if another one that has not
  /// ended writes the same file, or if another window owns the queue.
  int add(QueuedRender render);
  /// Keeps a waiting or running render for later.
  void pause(int number);
  /// A paused or failed render waits again; it continues from its checkpoint.
  void resume(int number);
  /// Removes a render and its checkpoint; a finished picture stays.
  void cancel(int number);

  /// The render whose process is to be started: the first waiting one, unless another one runs.
  std::optional<int> next() const;
  void started(int number);
  /// What its program has written to stderr: its progress bar, and messages.
  void said(int number, std::string_view text);
  /// Its process has ended. `exit`: the exit code; negative for a process that was killed.
  void ended(int number, int exit);

 private:
  QueuedRender& render(int number);
  void read();
  void changed();
  void take_line(QueuedRender& render, const std::string& line);

  std::filesystem::path file_;
  int lock_ = -1;
  int active_ = 0;  ///< The render whose process has not ended; 0: none.
  std::vector<QueuedRender> all_;
  std::string line_;      ///< The unfinished line of the running program.
  std::string messages_;  ///< Its last lines without a progress bar.
  uint64_t revision_ = 0;
};

}  // namespace vug::workbench
