// SPDX-License-Identifier: Apache-2.0
// Reports changes of files.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace vug::watch {

/// Compares the sizes, times and identities of files with those that it saw last. Where the system
/// reports events in their folders (inotify), it looks at once; otherwise, and in any case once a
/// second, it looks without being asked, as network file systems report nothing. Editors may write
/// a file in place, or replace it by another one. Not thread-safe.
class FileWatcher {
 public:
  enum class Method { events, polling };
  /// `polling` never asks the system for events.
  explicit FileWatcher(Method method = Method::events);
  ~FileWatcher();
  FileWatcher(const FileWatcher&) = delete;
  FileWatcher& operator=(const FileWatcher&) = delete;

  /// Replaces the list of files, which need not exist. The state of new files now is the known one.
  void watch(const std::vector<std::filesystem::path>& files);

  /// Returns true once a file has changed since the last change that was reported, and has not
  /// changed for `quiet`, since programs save a file in several steps; false after the time.
  bool wait(std::chrono::milliseconds time, std::chrono::milliseconds quiet);

 private:
  /// The state of a file; all 0 if it does not exist.
  struct Stamp {
    uint64_t size = 0, inode = 0;
    int64_t nanoseconds = 0;
    bool operator==(const Stamp&) const = default;
  };
  static Stamp stamp_of(const std::filesystem::path& file);
  /// Whether the system reports the changes in all folders.
  bool has_events_of_all() const;
  /// Whether it is time to look: after an event, or a while after the last look.
  bool is_due() const;
  /// Whether a file differs from its known state, which becomes the current one.
  bool look();
  void wait_for_event(std::chrono::milliseconds time);

  int events_ = -1;                               ///< The descriptor of inotify; -1: none.
  bool has_event_ = false;                        ///< Since the last look.
  std::chrono::steady_clock::time_point looked_;  ///< The time of the last look.
  std::map<std::filesystem::path, int> folders_;  ///< With the number of their watch.
  std::map<std::filesystem::path, Stamp> known_;
};

}  // namespace vug::watch
