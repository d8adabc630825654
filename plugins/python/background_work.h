// Long work beside Python: it runs on a thread of its own, and the thread that asked for it waits,
// without the interpreter's lock, for what there is to tell. So callbacks run on the caller's
// thread (which may be the only one that may touch Blender's data or a window), Ctrl-C stops work
// within a tenth of a second, and no thread that works ever waits for Python.
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

/// What work has to tell, from any of its threads.
class EventQueue {
 public:
  void report(const std::string& stage, double share);
  void warn(std::vector<std::string> texts);

  struct Events {
    std::vector<std::pair<std::string, double>> reports;  ///< Of each stage the last.
    std::vector<std::string> warnings;
    bool done = false;
  };
  void finish();
  /// Waits until there is something, at most a tenth of a second; takes it out.
  Events wait();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  Events events_;
};

/// Whom to tell; nobody where there is none.
using Callback = std::optional<py::function>;

/// Does `work` and calls `callback(share, what)` as it goes; `threads` bounds its
/// threads, 0: all cores. What the callback or Ctrl-C raises, or a callback that returns False,
/// cancels `progress`, and is raised when the work has stopped; else what the work throws.
void run_in_background(EventQueue& queue, Progress& progress, const Callback& callback, int threads,
                       const std::function<void()>& work);

}  // namespace vug::python
