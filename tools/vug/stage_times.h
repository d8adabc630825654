// SPDX-License-Identifier: Apache-2.0
// The wall-clock times of the stages of a run.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace vug::cli {

class StageTimes {
 public:
  using Clock = std::chrono::steady_clock;

  /// Receives the reports of a Progress: 0 begins a stage, 1 ends it.
  void update(const std::string& stage, double fraction);
  /// Seconds since the current stage began, or for which the last one ran.
  double stage_seconds() const { return stage_seconds_; }
  /// Seconds since the process started.
  double total_seconds() const;

  /// "88.2 s in all: rendering 61.0 s, voxels 9.1 s, other 0.4 s": stages by their time, with those
  /// of all products together. Stages below a hundredth of the total, and the time between stages,
  /// are the other ones.
  std::string summary() const;

 private:
  const Clock::time_point start_ = Clock::now();
  Clock::time_point stage_start_ = start_;
  double stage_seconds_ = 0;
  std::vector<std::pair<std::string, double>> seconds_;  ///< Times of the stages that have ended.
};

}  // namespace vug::cli
