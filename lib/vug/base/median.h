// SPDX-License-Identifier: Apache-2.0
// The median of a list of values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace vug {

/// The median; the upper one of the two middle values if their number is even. `values` must not be
/// empty or contain NaN.
template <class T>
T median(std::vector<T> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace vug
