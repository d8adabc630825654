// SPDX-License-Identifier: Apache-2.0
#include "progress_bar.h"

#include "verb.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <mutex>

namespace vug::cli {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<Progress*> interrupted = nullptr;

/// Only sets an atomic flag; a second signal kills the process. Before any work has begun the
/// process can end at once, because nothing needs to be cleaned up.
void on_signal(int signal) {
  std::signal(signal, SIG_DFL);
  if (Progress* const progress = interrupted.load()) return progress->cancel();
  constexpr char kMessage[] = "error: stopped on request\n";
  const ssize_t written = write(STDERR_FILENO, kMessage, sizeof kMessage - 1);
  (void)written;
  _exit(kFailed);
}

class Bar {
 public:
  void draw(const std::string& stage, double fraction) {
    const std::lock_guard lock(mutex_);
    if (stage != stage_) {
      stage_ = stage;
      start_ = Clock::now();
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    std::string left;
    if (fraction >= 1)
      left = fmt::format("{:.1f} s", seconds);
    else if (fraction > 0.02 && seconds > 1)
      left = fmt::format("{:.0f} s left", seconds * (1 - fraction) / fraction);
    const int full = static_cast<int>(fraction * kWidth);
    fmt::print(stderr, "\r{:<28.28} [{:=<{}}{:<{}}] {:3.0f}% {:<12}", stage, "", full, "",
               kWidth - full, 100 * fraction, left);
    if (fraction >= 1) fmt::print(stderr, "\n");
    open_ = fraction < 1;
    std::fflush(stderr);
  }
  void clear() {
    const std::lock_guard lock(mutex_);
    if (open_) fmt::print(stderr, "\n");
    open_ = false;
  }

 private:
  static constexpr int kWidth = 30;
  std::mutex mutex_;
  std::string stage_;
  Clock::time_point start_;
  bool open_ = false;
};

Bar& bar() {
  static Bar only;
  return only;
}

}  // namespace

Progress& terminal_progress(ProgressBarMode shown) {
  static Progress silent;
  static Progress drawn(
      [](const std::string& stage, double fraction) { bar().draw(stage, fraction); });
  const bool draw = shown == ProgressBarMode::always ||
                    (shown == ProgressBarMode::on_terminals && isatty(STDERR_FILENO));
  Progress& progress = draw ? drawn : silent;
  interrupted = &progress;
  return progress;
}

void install_signal_handlers() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

void clear_progress_bar() { bar().clear(); }

}  // namespace vug::cli
