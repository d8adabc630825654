// SPDX-License-Identifier: Apache-2.0
// Measures how long the event loop was blocked.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <ctime>

namespace vug::studio {

class Heartbeat {
 public:
  /// A beat every `interval` milliseconds.
  explicit Heartbeat(int interval) : interval_(interval) {
    QObject::connect(&timer_, &QTimer::timeout, [this] { beat(); });
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.start(interval);
  }
  /// The longest delay of a beat since the last reset, milliseconds.
  qint64 worst_delay() const { return worst_delay_; }
  /// The longest time for which this thread computed between two beats, milliseconds. Other
  /// programs do not affect it, so that tests can assert it on busy machines.
  qint64 worst_work() const { return worst_work_; }
  void reset() {
    worst_delay_ = worst_work_ = 0;
    since_.invalidate();
  }

 private:
  static qint64 computed() {
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1000 * static_cast<qint64>(now.tv_sec) + now.tv_nsec / 1'000'000;
  }
  void beat() {
    if (since_.isValid()) {
      worst_delay_ = std::max(worst_delay_, since_.elapsed() - interval_);
      worst_work_ = std::max(worst_work_, computed() - before_);
    }
    since_.start();
    before_ = computed();
  }

  int interval_;
  qint64 worst_delay_ = 0, worst_work_ = 0, before_ = 0;
  QTimer timer_;
  QElapsedTimer since_;
};

}  // namespace vug::studio
