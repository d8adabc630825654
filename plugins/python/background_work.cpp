// SPDX-License-Identifier: Apache-2.0
#include "background_work.h"

#include "errors.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>

#include <chrono>
#include <exception>
#include <thread>

namespace vug::python {
namespace {

constexpr std::chrono::milliseconds kPollInterval{100};

/// Passes events to Python. Returns false if the callback asks to stop.
bool deliver(const EventQueue::Events& events, const Callback& callback) {
  warn(events.warnings);
  if (!callback) return true;
  for (const auto& [stage, share] : events.reports)
    if ((*callback)(share, stage).is(py::bool_(false))) return false;
  return true;
}

}  // namespace

void EventQueue::report(const std::string& stage, double share) {
  {
    const std::lock_guard lock(mutex_);
    auto& reports = events_.reports;
    if (reports.empty() || reports.back().first != stage)
      reports.emplace_back(stage, share);
    else
      reports.back().second = share;
  }
  changed_.notify_one();
}

void EventQueue::warn(std::vector<std::string> texts) {
  {
    const std::lock_guard lock(mutex_);
    for (std::string& text : texts) events_.warnings.push_back(std::move(text));
  }
  changed_.notify_one();
}

void EventQueue::finish() {
  {
    const std::lock_guard lock(mutex_);
    events_.done = true;
  }
  changed_.notify_one();
}

EventQueue::Events EventQueue::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kPollInterval, [this] {
    return events_.done || !events_.reports.empty() || !events_.warnings.empty();
  });
  return std::exchange(events_, {});
}

void run_in_background(EventQueue& queue, Progress& progress, const Callback& callback, int threads,
                       const std::function<void()>& work) {
  std::exception_ptr fault, raised;
  bool stopped = false;
  std::thread worker([&] {
    try {
      with_threads(threads, [&] { work(); });
    } catch (...) {
      fault = std::current_exception();
    }
    queue.finish();
  });
  for (bool done = false; !done;) {
    EventQueue::Events events;
    {
      const py::gil_scoped_release others;
      events = queue.wait();
    }
    done = events.done;
    if (stopped) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      stopped = !deliver(events, callback);
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
