// SPDX-License-Identifier: Apache-2.0
// A quantile of a list of values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vug {

/// The value below which the fraction `share`, in 0..1, of the values lies: the element floor(share
/// (n - 1)) of the sorted list. `values` must not be empty or contain NaN.
template <class T>
T quantile(std::vector<T> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace vug
