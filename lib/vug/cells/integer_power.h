// SPDX-License-Identifier: Apache-2.0
// Powers with whole exponents, with the same bits on every machine.
#pragma once

namespace vug::cells {

/// base to the power of `exponent`, which is at least 1.
template <class T>
T integer_power(T base, int exponent) {
  T product = base;
  for (int i = 1; i < exponent; ++i) product *= base;
  return product;
}

}  // namespace vug::cells
