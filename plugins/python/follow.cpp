#include "follow.h"

#include "errors.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>

#include <chrono>
#include <exception>
#include <thread>

namespace vug::python {
namespace {

constexpr std::chrono::milliseconds kPatience{100};

/// Tells a letter; false where the answer is to stop.
bool tell(const Post::Letter& letter, const Callback& callback) {
  warn(letter.warnings);
  if (!callback) return true;
  for (const auto& [stage, share] : letter.reports)
    if ((*callback)(share, stage).is(py::bool_(false))) return false;
  return true;
}

}  // namespace

void Post::report(const std::string& stage, double share) {
  {
    const std::lock_guard lock(mutex_);
    auto& reports = letter_.reports;
    if (reports.empty() || reports.back().first != stage)
      reports.emplace_back(stage, share);
    else
      reports.back().second = share;
  }
  news_.notify_one();
}

void Post::warn(std::vector<std::string> texts) {
  {
    const std::lock_guard lock(mutex_);
    for (std::string& text : texts) letter_.warnings.push_back(std::move(text));
  }
  news_.notify_one();
}

void Post::finish() {
  {
    const std::lock_guard lock(mutex_);
    letter_.done = true;
  }
  news_.notify_one();
}

Post::Letter Post::wait() {
  std::unique_lock lock(mutex_);
  news_.wait_for(lock, kPatience, [this] {
    return letter_.done || !letter_.reports.empty() || !letter_.warnings.empty();
  });
  return std::exchange(letter_, {});
}

void follow(Post& post, Progress& progress, const Callback& callback, int threads,
            const std::function<void()>& work) {
  std::exception_ptr fault, raised;
  bool stopped = false;
  std::thread worker([&] {
    try {
      const ThreadLimit limit(threads);
      work();
    } catch (...) {
      fault = std::current_exception();
    }
    post.finish();
  });
  for (bool done = false; !done;) {
    Post::Letter letter;
    {
      const py::gil_scoped_release others;
      letter = post.wait();
    }
    done = letter.done;
    if (stopped) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      stopped = !tell(letter, callback);
    } catch (...) {
      raised = std::current_exception();
      stopped = true;
    }
    if (stopped) progress.cancel();
  }
  {
    const py::gil_scoped_release others;
    worker.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (fault) std::rethrow_exception(fault);
  if (stopped) progress.check();
}

}  // namespace vug::python
