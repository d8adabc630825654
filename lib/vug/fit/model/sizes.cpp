// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/model/sizes.h>

#include <algorithm>

namespace vug::fit {
namespace {

constexpr double kMinGain = 1e-9;

/// The largest gain of these sizes in each cell, or 0.
std::vector<double> best_of(const SizeGains& gains, const std::vector<size_t>& sizes) {
  std::vector<double> out;
  for (const std::vector<double>& cell : gains.cells) {
    double best = 0;
    for (const size_t size : sizes) best = std::max(best, cell[size]);
    out.push_back(best);
  }
  return out;
}

/// The size that adds most to sizes with the gains `others`, and the resulting total gain.
std::pair<size_t, double> best_addition(const SizeGains& gains, const std::vector<double>& others) {
  std::vector<double> together(gains.count(), 0);
  for (size_t cell = 0; cell < others.size(); ++cell) {
    const double current = others[cell];
    const double* own = gains.cells[cell].data();
    for (size_t size = 0; size < together.size(); ++size)
      together[size] += own[size] > current ? own[size] : current;
  }
  const auto most = std::max_element(together.begin(), together.end());
  return {static_cast<size_t>(most - together.begin()), *most};
}

/// Exchanges single sizes for better ones until no exchange helps; returns the total gain.
double exchange(const SizeGains& gains, std::vector<size_t>& sizes, double gain) {
  for (bool better = true; better;) {
    better = false;
    for (size_t& size : sizes) {
      std::vector<size_t> others;
      for (const size_t& other : sizes)
        if (&other != &size) others.push_back(other);
      const auto [at, most] = best_addition(gains, best_of(gains, others));
      if (!(most > gain + kMinGain)) continue;
      size = at, gain = most, better = true;
    }
  }
  return gain;
}

SizeChoice chosen(const SizeGains& gains, const std::vector<size_t>& sizes) {
  std::vector<WindowSize> all;
  for (const size_t size : sizes) all.push_back(gains.size(size));
  return best_of_each(std::move(all), gains.cells.size(),
                      [&](size_t cell, size_t k) { return gains.cells[cell][sizes[k]]; });
}

}  // namespace

std::vector<SizeChoice> choose_sizes(const SizeGains& gains, int most, double cost) {
  std::vector<SizeChoice> out;
  double limit = 0;  // Upper bound: the gain with as many sizes as cells.
  for (const std::vector<double>& cell : gains.cells)
    limit += std::max(0.0, *std::max_element(cell.begin(), cell.end()));
  std::vector<size_t> sizes;
  double gain = 0;
  while (static_cast<int>(sizes.size()) < most && (sizes.empty() || limit - gain > cost)) {
    const auto [size, with] = best_addition(gains, best_of(gains, sizes));
    if (!sizes.empty() && !(with > gain + kMinGain)) break;
    sizes.push_back(size);
    gain = exchange(gains, sizes, with);
    out.push_back(chosen(gains, sizes));
  }
  return out;
}

}  // namespace vug::fit
