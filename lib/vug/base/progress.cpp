// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/progress.h>

#include <algorithm>

namespace vug {

void Progress::begin(std::string stage, uint64_t total) {
  check();
  if (!watcher_) return;  // no state: all work without a watcher shares `none`
  end();
  stage_ = std::move(stage);
  if (!product_.empty()) stage_ += " of '" + product_ + "'";
  total_ = std::max<uint64_t>(total, 1);
  done_ = 0;
  percent_ = -1;
  advance(0);
}

void Progress::advance(uint64_t units) {
  if (!watcher_) return;
  const uint64_t done = done_.fetch_add(units, std::memory_order_relaxed) + units;
  const int percent = static_cast<int>(std::min<uint64_t>(99, 100 * done / total_));
  int seen = percent_.load(std::memory_order_relaxed);
  // The thread that increments the percentage reports it.
  while (percent > seen && !percent_.compare_exchange_weak(seen, percent)) {
  }
  if (percent > seen)
    report(percent, std::min(0.99, static_cast<double>(done) / static_cast<double>(total_)));
}

void Progress::report(int percent, double fraction) {
  const std::lock_guard<std::mutex> one_at_a_time(reporting_);
  // Another thread may have reported more in the meantime.
  if (percent == percent_.load(std::memory_order_relaxed)) watcher_(stage_, fraction);
}

void Progress::end() {
  check();
  if (watcher_ && percent_.exchange(100) < 100) report(100, 1.0);
}

void Progress::check() const {
  if (cancelled()) throw Error(ErrorCode::cancelled, "stopped on request");
}

void check_cancelled() {
  if (const Progress* progress = CancellableScope::innermost()) progress->check();
}

Progress::Product::Product(Progress& progress, std::string name) : progress_(progress) {
  if (progress_.watcher_) outer_ = std::exchange(progress_.product_, std::move(name));
}

Progress::Product::~Product() {
  if (progress_.watcher_) progress_.product_ = std::move(outer_);
}

Progress& Progress::none() {
  static Progress silent;
  return silent;
}

}  // namespace vug
