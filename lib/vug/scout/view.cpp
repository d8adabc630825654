// SPDX-License-Identifier: Apache-2.0
#include <vug/scout/view.h>

#include <algorithm>

namespace vug::scout {

double median_distance(const View& view) {
  std::vector<float> all;
  for (const Seen& each : view.pixels) all.push_back(each.distance);
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return static_cast<double>(*middle);
}

}  // namespace vug::scout
