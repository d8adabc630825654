// SPDX-License-Identifier: Apache-2.0
// A cancellable computation on a thread of its own, whose results carry a generation number.
#pragma once

#include <vug/base/error.h>
#include <vug/base/progress.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace vug::workbench {

/// The owner starts, cancels and polls it on one thread. Starting replaces the computation that
/// runs: the old one is cancelled, and its results are dropped. A computation may publish
/// intermediate results; a poll returns the latest one.
template <class Result>
class Job {
 public:
  using Publish = std::function<void(Result)>;
  using Work = std::function<Result(Progress&, const Publish&)>;
  struct Update {
    uint64_t generation = 0;
    std::optional<Result> result;      ///< The latest result since the previous poll.
    std::optional<std::string> error;  ///< The computation failed.
    bool ended = false;
    std::string stage;
    double fraction = 0;  ///< Finished share of the stage, 0..1.
  };

  /// `notify` is called on the worker's thread whenever a poll would return something new.
  explicit Job(std::function<void()> notify = {}) : notify_(std::move(notify)) {}
  ~Job() { stop(); }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  uint64_t start(Work work) {
    stop();
    shared_ = std::make_shared<Shared>(++generation_, notify_);
    thread_ = std::thread([shared = shared_, work = std::move(work)] { run(*shared, work); });
    return generation_;
  }

  /// Asks the computation to end; a computation that supports it returns its best result so far.
  void cancel() {
    if (shared_) shared_->progress.cancel();
  }
  bool running() const {
    if (!shared_) return false;
    const std::lock_guard lock(shared_->mutex);
    return !shared_->update.ended;
  }
  /// Whether there is a computation whose end has not been taken by `stop`.
  bool exists() const { return shared_ != nullptr; }
  /// The news since the previous poll.
  Update poll() {
    if (!shared_) return {};
    const std::lock_guard lock(shared_->mutex);
    Update out = shared_->update;
    shared_->update.result.reset();
    return out;
  }
  /// Cancels and waits for the end of the computation; its results are dropped.
  void stop() {
    cancel();
    if (thread_.joinable()) thread_.join();
    shared_.reset();
  }

 private:
  struct Shared {
    Shared(uint64_t generation, std::function<void()> told)
        : notify(std::move(told)), progress([this](const std::string& stage, double fraction) {
            {
              const std::lock_guard lock(mutex);
              update.stage = stage;
              update.fraction = fraction;
            }
            if (notify) notify();
          }) {
      update.generation = generation;
    }
    std::function<void()> notify;
    Progress progress;
    mutable std::mutex mutex;
    Update update;
  };

  static void run(Shared& shared, const Work& work) {
    const auto change = [&](const std::function<void(Update&)>& apply) {
      {
        const std::lock_guard lock(shared.mutex);
        apply(shared.update);
      }
      if (shared.notify) shared.notify();
    };
    try {
      Result last = work(shared.progress, [&](Result result) {
        change([&](Update& update) { update.result = std::move(result); });
      });
      change([&](Update& update) { update.result = std::move(last), update.ended = true; });
    } catch (const Error& error) {
      const bool cancelled = error.code() == ErrorCode::cancelled;
      change([&](Update& update) {
        if (!cancelled) update.error = error.what();
        update.ended = true;
      });
    } catch (const std::exception& error) {
      change([&](Update& update) { update.error = error.what(), update.ended = true; });
    }
  }

  std::function<void()> notify_;
  uint64_t generation_ = 0;
  std::shared_ptr<Shared> shared_;
  std::thread thread_;
};

}  // namespace vug::workbench
