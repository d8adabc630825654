// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/quality.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {

double Quality::share(size_t low, size_t high) const {
  size_t all = 0, in = 0;
  for (size_t d = 0; d < degrees.size(); ++d) {
    all += degrees[d];
    if (d >= low && d <= high) in += degrees[d];
  }
  return all > 0 ? static_cast<double>(in) / static_cast<double>(all) : 0;
}

Quality quality(const Network& n) {
  Quality out;
  double sum = 0, squares = 0;
  size_t count = 0;
  for (uint32_t i = 0; i < n.size(); ++i) {
    ++out.degrees[std::min<size_t>(n.links.degree(i), out.degrees.size() - 1)];
    if (n.links.degree(i) == 0) continue;
    float nearest = std::numeric_limits<float>::infinity();
    for (const uint32_t to : n.links.of(i))
      nearest = std::min(nearest, (n.position[to] - n.position[i]).length());
    sum += static_cast<double>(nearest);
    squares += static_cast<double>(nearest) * static_cast<double>(nearest);
    ++count;
  }
  if (count == 0) return out;
  out.nearest = sum / static_cast<double>(count);
  const double variance = squares / static_cast<double>(count) - out.nearest * out.nearest;
  out.variation = std::sqrt(std::max(0.0, variance)) / out.nearest;
  return out;
}

}  // namespace vug::cells
