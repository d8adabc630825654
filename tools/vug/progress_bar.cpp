// SPDX-License-Identifier: Apache-2.0
#include "progress_bar.h"

#include "verb.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <mutex>

namespace vug::cli {
namespace {

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

enum class Style { bars, lines, none };

Style style_of(ProgressBarMode shown) {
  if (shown == ProgressBarMode::never) return Style::none;
  const bool bars = shown == ProgressBarMode::always || isatty(STDERR_FILENO);
  return bars ? Style::bars : Style::lines;
}

/// Shows the stages of the process, and records their times.
class StageDisplay {
 public:
  const StageTimes& times() const { return times_; }

  void update(Style style, const std::string& stage, double fraction) {
    const std::lock_guard lock(mutex_);
    times_.update(stage, fraction);
    if (style == Style::bars) draw(stage, fraction);
    if (style == Style::lines) log(stage, fraction);
  }
  void clear() {
    const std::lock_guard lock(mutex_);
    if (open_) fmt::print(stderr, "\n");
    open_ = false;
  }

 private:
  static constexpr int kNameWidth = 38, kWidth = 20;
  static constexpr double kBrief = 0.1;       ///< Shorter stages leave no line, in seconds.
  static constexpr double kLogInterval = 60;  ///< Seconds between lines about a long stage.

  /// The time that the stage took or that is left.
  std::string time_text(double fraction) const {
    const double seconds = times_.stage_seconds();
    if (fraction >= 1) return fmt::format("{:.1f} s", seconds);
    if (fraction <= 0.02 || seconds <= 1) return "";
    return fmt::format("{:.0f} s left", seconds * (1 - fraction) / fraction);
  }
  void draw(const std::string& stage, double fraction) {
    const int full = static_cast<int>(fraction * kWidth);
    fmt::print(stderr, "\r{:<{}.{}} [{:=<{}}{:<{}}] {:3.0f}% {:<12}", stage, kNameWidth, kNameWidth,
               "", full, "", kWidth - full, 100 * fraction, time_text(fraction));
    open_ = fraction < 1;
    if (!open_)  // the next output replaces the line of a brief stage
      fmt::print(stderr, "{}",
                 times_.stage_seconds() < kBrief
                     ? fmt::format("\r{:<{}}\r", "", kNameWidth + kWidth + 21)
                     : "\n");
    std::fflush(stderr);
  }
  void log(const std::string& stage, double fraction) {
    const double seconds = times_.stage_seconds();
    if (fraction <= 0) logged_ = 0;
    if (fraction >= 1 && seconds >= kBrief)
      fmt::print(stderr, "{}: {}\n", stage, time_text(fraction));
    if (fraction >= 1 || seconds - logged_ < kLogInterval) return;
    logged_ = seconds;
    fmt::print(stderr, "{}: {:.0f} %, {}\n", stage, 100 * fraction, time_text(fraction));
  }

  std::mutex mutex_;
  StageTimes times_;
  double logged_ = 0;  ///< Seconds of the stage at its last line in a log.
  bool open_ = false;
};

StageDisplay& display() {
  static StageDisplay only;
  return only;
}

}  // namespace

Progress& terminal_progress(ProgressBarMode shown) {
  static Progress progress([style = style_of(shown)](const std::string& stage, double fraction) {
    display().update(style, stage, fraction);
  });
  interrupted = &progress;
  return progress;
}

void report_stage(ProgressBarMode shown, const std::string& stage, double fraction) {
  display().update(style_of(shown), stage, fraction);
}

const StageTimes& stage_times() { return display().times(); }

void install_signal_handlers() {
  display();  // its clock starts with the process
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

void clear_progress_bar() { display().clear(); }

}  // namespace vug::cli
