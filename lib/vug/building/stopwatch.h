// SPDX-License-Identifier: Apache-2.0
// Adds the time of a scope to a total.
#pragma once

#include <chrono>

namespace vug::building {

class Stopwatch {
 public:
  /// `total`: wall-clock seconds.
  explicit Stopwatch(double& total) : total_(total) {}
  ~Stopwatch() { total_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& total_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace vug::building
