// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/search/segments.h>

#include <algorithm>
#include <cstddef>
#include <deque>

namespace vug::fit {

std::vector<Segment> best_segments(const std::vector<double>& before, const SegmentLimits& limits) {
  const auto places = static_cast<int>(before.size()) - 1;
  const auto at = [](int i) { return static_cast<size_t>(std::max(0, i)); };
  // best[n][i]: largest gain of n segments before position i; size[n][i]: size of the last of them
  // if it ends at i, else 0.
  std::vector<std::vector<double>> best(1, std::vector<double>(before.size(), 0));
  std::vector<std::vector<int>> size(1);
  for (int n = 1; n <= limits.max_count; ++n) {
    std::vector<double> row(before.size(), -1e300);
    std::vector<int> last(before.size(), 0);
    const std::vector<double>& fewer = best.back();
    // Monotonic queue: its front is the best of the starts that are neither too near nor too far.
    std::deque<int> starts;
    const auto worth = [&](int start) {
      return (n > 1 ? fewer[at(start - 1)] : 0) - before[at(start)];
    };
    for (int end = limits.min_size; end <= places; ++end) {
      row[at(end)] = row[at(end - 1)];
      const int fresh = end - limits.min_size;
      if (n == 1 || fresh > 0) {
        while (!starts.empty() && worth(starts.back()) <= worth(fresh)) starts.pop_back();
        starts.push_back(fresh);
      }
      while (!starts.empty() && starts.front() < end - limits.max_size) starts.pop_front();
      if (starts.empty()) continue;
      const double gain = worth(starts.front()) + before[at(end)] - limits.cost;
      if (gain > row[at(end)]) {
        row[at(end)] = gain;
        last[at(end)] = end - starts.front();
      }
    }
    if (!(row.back() > fewer.back())) break;
    best.push_back(std::move(row));
    size.push_back(std::move(last));
  }
  std::vector<Segment> out;
  int end = places;
  for (size_t n = best.size() - 1; n > 0; --n) {
    while (size[n][at(end)] == 0) --end;
    out.push_back({end - size[n][at(end)], end});
    end = out.back().start - 1;
  }
  std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace vug::fit
