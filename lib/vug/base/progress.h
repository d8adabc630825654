// SPDX-License-Identifier: Apache-2.0
// Progress reports and cancellation of long work.
#pragma once

#include <vug/base/cancellable_scope.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>

namespace vug {

/// Shared by the worker and the watcher; thread-safe. The worker calls `advance` and, from time to
/// time, `check`, which throws Error(cancelled) once `cancel` was called. The watcher's callback
/// runs on a worker thread: with 0 when a stage begins, at most once per percent below 1 while it
/// works, and with 1 when it ends; one call at a time and never backwards within a stage. A stage
/// that begins ends the one before it. The callback must not throw.
class Progress {
 public:
  using Watcher = std::function<void(const std::string& stage, double fraction)>;

  Progress() = default;
  explicit Progress(Watcher watcher) : watcher_(std::move(watcher)) {}

  /// Starts a named stage of `total` units; resets the fraction to 0.
  void begin(std::string stage, uint64_t total = 1);
  void advance(uint64_t units = 1);
  void end();

  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  void check() const;

  /// A Progress without a watcher; any number of workers may share it at the same time.
  static Progress& none();

  /// Names the product of the stages that begin while it exists: "voxels of 'rock'".
  class Product {
   public:
    Product(Progress& progress, std::string name);
    ~Product();
    Product(const Product&) = delete;
    Product& operator=(const Product&) = delete;

   private:
    Progress& progress_;
    std::string outer_;
  };

 private:
  void report(int percent, double fraction);

  Watcher watcher_;
  std::mutex reporting_;
  std::string stage_, product_;
  std::atomic<uint64_t> done_{0};
  uint64_t total_ = 0;
  std::atomic<int> percent_{100};  ///< 100: no stage is running.
  std::atomic<bool> cancelled_{false};
};

/// Runs work that does not report its own progress as one stage, and returns its result. The work
/// can be cancelled: see CancellableScope.
template <class Work>
std::invoke_result_t<Work> run_stage(Progress& progress, std::string name, const Work& work) {
  progress.begin(std::move(name));
  const CancellableScope scope(progress);
  if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
    work();
    progress.end();
  } else {
    std::invoke_result_t<Work> result = work();
    progress.end();
    return result;
  }
}

}  // namespace vug
