// SPDX-License-Identifier: Apache-2.0
// Runs long work on a separate thread while the calling thread waits for events without holding the
// interpreter's lock. Callbacks therefore run on the calling thread (possibly the only one that may
// access Blender's data or a window), Ctrl-C stops work within a tenth of a second, and working
// threads never wait for Python.
#pragma once

#include "binding.h"

#include <vug/base/progress.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace vug::python {

/// Progress reports and warnings from any working thread to the calling thread.
class EventQueue {
 public:
  void report(const std::string& stage, double share);
  void warn(std::vector<std::string> texts);

  /// Events since the last call of wait().
  struct Events {
    std::vector<std::pair<std::string, double>> reports;  ///< The last report of each stage.
    std::vector<std::string> warnings;
    bool done = false;
  };
  void finish();
  /// Waits at most a tenth of a second for events, and removes and returns them.
  Events wait();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  Events events_;
};

/// The progress callback, if any.
using Callback = std::optional<py::function>;

/// Runs `work` with at most `threads` threads (0: all cores) and calls `callback(share, what)`
/// during the work. An exception of the callback, Ctrl-C or a callback that returns False cancels
/// `progress`; the exception is raised after the work has stopped. Exceptions of the work are
/// rethrown.
void run_in_background(EventQueue& queue, Progress& progress, const Callback& callback, int threads,
                       const std::function<void()>& work);

}  // namespace vug::python
