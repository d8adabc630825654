// SPDX-License-Identifier: Apache-2.0
// Progress reports and cancellation of long work.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>

namespace vug {

/// Shared by the worker and the watcher; thread-safe. The worker calls `advance` and, from time to
/// time, `check`, which throws Error(cancelled) once `cancel` was called. The watcher's callback
/// runs on a worker thread, at most once per percent, one call at a time and never backwards within
/// a stage; it must not throw.
class Progress {
 public:
  using Watcher = std::function<void(const std::string& stage, double fraction)>;

  Progress() = default;
  explicit Progress(Watcher watcher) : watcher_(std::move(watcher)) {}

  /// Starts a named stage of `total` units; resets the fraction to 0.
  void begin(std::string stage, uint64_t total);
  void advance(uint64_t units = 1);
  void end();

  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  void check() const;

  /// A Progress without a watcher; any number of workers may share it at the same time.
  static Progress& none();

 private:
  void report(int percent, double fraction);

  Watcher watcher_;
  std::mutex reporting_;
  std::string stage_;
  std::atomic<uint64_t> done_{0};
  uint64_t total_ = 0;
  std::atomic<int> percent_{-1};
  std::atomic<bool> cancelled_{false};
};

}  // namespace vug
