// SPDX-License-Identifier: Apache-2.0
// The root of a monotonic function, to the last bits of a double.
#pragma once

namespace vug::field {

/// The number in low..high, both positive or 0, at which the increasing function becomes `wanted`.
template <class Function>
double bisected(double low, double high, double wanted, const Function& function) {
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (function(middle) < wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace vug::field
