// SPDX-License-Identifier: Apache-2.0
// Otsu's thresholds for three classes.
#include <vug/scout/score.h>

#include <algorithm>

namespace vug::scout {
namespace {

constexpr size_t kBins = 64;

/// Sums of the counts and of count times bin, up to each bin.
struct Sums {
  std::array<double, kBins + 1> count{}, moment{};
  double mean(size_t begin, size_t end) const {
    const double n = count[end] - count[begin];
    return n > 0 ? (moment[end] - moment[begin]) / n : 0;
  }
  double between(size_t begin, size_t end, double centre) const {
    const double n = count[end] - count[begin], off = mean(begin, end) - centre;
    return n * off * off;
  }
};

}  // namespace

OtsuClasses otsu_classes(const std::vector<double>& values) {
  OtsuClasses out;
  if (values.empty()) return out;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double low = *least, width = (*most - low) / static_cast<double>(kBins);
  if (!(width > 0)) {
    out.low = out.high = low;
    out.shares = {0, 0, 1};
    return out;
  }
  std::array<double, kBins> counts{};
  for (const double value : values)
    ++counts[std::min(kBins - 1, static_cast<size_t>((value - low) / width))];
  Sums sums;
  for (size_t i = 0; i < kBins; ++i) {
    sums.count[i + 1] = sums.count[i] + counts[i];
    sums.moment[i + 1] = sums.moment[i] + counts[i] * static_cast<double>(i);
  }
  const double centre = sums.mean(0, kBins);
  double total = 0, best = -1;
  for (size_t i = 0; i < kBins; ++i)
    total += counts[i] * (static_cast<double>(i) - centre) * (static_cast<double>(i) - centre);
  size_t first = 1, second = 2;
  for (size_t i = 1; i < kBins - 1; ++i)
    for (size_t j = i + 1; j < kBins; ++j) {
      const double between =
          sums.between(0, i, centre) + sums.between(i, j, centre) + sums.between(j, kBins, centre);
      if (between <= best) continue;
      best = between, first = i, second = j;
    }
  const auto n = static_cast<double>(values.size());
  out.low = low + width * static_cast<double>(first);
  out.high = low + width * static_cast<double>(second);
  out.shares = {sums.count[first] / n, (sums.count[second] - sums.count[first]) / n,
                (n - sums.count[second]) / n};
  out.separation = total > 0 ? best / total : 0;
  return out;
}

}  // namespace vug::scout
