// SPDX-License-Identifier: Apache-2.0
#include <vug/inference/convergence.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace vug::inference {
namespace {

double mean_of(const Trace& trace, size_t begin, size_t end) {
  double sum = 0;
  for (size_t i = begin; i < end; ++i) sum += trace[i];
  return sum / static_cast<double>(end - begin);
}

/// The sum of products of deviations at distance `lag`.
double covariance(const Trace& trace, double mean, size_t lag) {
  double sum = 0;
  for (size_t i = 0; i + lag < trace.size(); ++i)
    sum += (trace[i] - mean) * (trace[i + lag] - mean);
  return sum;
}

}  // namespace

double autocorrelation_time(const Trace& trace) {
  if (trace.size() < 2) return 1;
  const double mean = mean_of(trace, 0, trace.size());
  const double variance = covariance(trace, mean, 0);
  if (!(variance > 0)) return 1;
  double time = 1;
  for (size_t lag = 1; lag < trace.size() / 2; ++lag) {
    time += 2 * covariance(trace, mean, lag) / variance;
    if (static_cast<double>(lag) >= 5 * time) break;
  }
  return std::max(1.0, time);
}

double effective_size(const Trace& trace) {
  return static_cast<double>(trace.size()) / autocorrelation_time(trace);
}

double scale_reduction(const std::vector<Trace>& traces) {
  std::vector<double> means;
  double within = 0;
  size_t half = std::numeric_limits<size_t>::max();
  for (const Trace& trace : traces) half = std::min(half, trace.size() / 2);
  if (traces.empty() || half < 2) return std::numeric_limits<double>::infinity();
  for (const Trace& trace : traces)
    for (const size_t begin : {size_t{0}, trace.size() - half}) {
      const double mean = mean_of(trace, begin, begin + half);
      double sum = 0;
      for (size_t i = begin; i < begin + half; ++i) sum += (trace[i] - mean) * (trace[i] - mean);
      within += sum / static_cast<double>(half - 1);
      means.push_back(mean);
    }
  const auto count = static_cast<double>(means.size());
  within /= count;
  const double middle = mean_of(means, 0, means.size());
  double between = 0;
  for (const double mean : means) between += (mean - middle) * (mean - middle);
  between /= count - 1;  // variance of the halves' means
  if (!(within > 0)) return between > 0 ? std::numeric_limits<double>::infinity() : 1;
  const auto n = static_cast<double>(half);
  return std::sqrt(((n - 1) / n * within + between) / within);
}

double geweke(const Trace& trace) {
  const auto variance_of_mean = [](const Trace& part) {
    const double mean = mean_of(part, 0, part.size());
    return covariance(part, mean, 0) / static_cast<double>(part.size()) / effective_size(part);
  };
  const auto tenth = static_cast<std::ptrdiff_t>(trace.size() / 10);
  if (tenth < 2) return 0;
  const Trace first(trace.begin(), trace.begin() + tenth);
  const Trace last(trace.end() - static_cast<std::ptrdiff_t>(trace.size() / 2), trace.end());
  const double apart = mean_of(first, 0, first.size()) - mean_of(last, 0, last.size());
  const double variance = variance_of_mean(first) + variance_of_mean(last);
  if (!(variance > 0))
    return apart == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), apart);
  return apart / std::sqrt(variance);
}

}  // namespace vug::inference
