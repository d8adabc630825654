// SPDX-License-Identifier: Apache-2.0
#include "stage_times.h"

#include <fmt/format.h>

#include <algorithm>

namespace vug::cli {
namespace {

/// Stages with a smaller fraction of the total are not listed.
constexpr double kListed = 0.01;

double since(StageTimes::Clock::time_point start) {
  return std::chrono::duration<double>(StageTimes::Clock::now() - start).count();
}

/// The stage without its product: "voxels" for "voxels of 'rock'".
std::string without_product(const std::string& stage) {
  return stage.substr(0, stage.find(" of '"));
}

}  // namespace

void StageTimes::update(const std::string& stage, double fraction) {
  if (fraction <= 0) stage_start_ = Clock::now();
  stage_seconds_ = since(stage_start_);
  if (fraction < 1) return;
  const std::string name = without_product(stage);
  const auto known = std::find_if(seconds_.begin(), seconds_.end(),
                                  [&](const auto& each) { return each.first == name; });
  if (known != seconds_.end())
    known->second += stage_seconds_;
  else
    seconds_.emplace_back(name, stage_seconds_);
}

double StageTimes::total_seconds() const { return since(start_); }

std::string StageTimes::summary() const {
  const double total = total_seconds();
  std::vector<std::pair<std::string, double>> listed = seconds_;
  std::stable_sort(listed.begin(), listed.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string out = fmt::format("{:.1f} s in all", total);
  double other = total;
  const char* separator = ": ";
  for (const auto& [name, seconds] : listed) {
    if (seconds < kListed * total) break;
    out += fmt::format("{}{} {:.1f} s", separator, name, seconds);
    other -= seconds;
    separator = ", ";
  }
  if (other >= kListed * total) out += fmt::format("{}other {:.1f} s", separator, other);
  return out;
}

}  // namespace vug::cli
