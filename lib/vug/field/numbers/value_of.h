// SPDX-License-Identifier: Apache-2.0
// The value of a number of any type without its derivatives.
#pragma once

#include <vug/field/numbers/dual.h>

#include <type_traits>

namespace vug::field {

inline const double& value_of(const double& x) { return x; }
inline const Pack& value_of(const Pack& x) { return x; }
template <class S>
const S& value_of(const Dual<S>& x) {
  return x.v;
}

/// A constant of type T, Pack or Dual<Pack>.
template <class T>
T without_derivatives(const Pack& value) {
  if constexpr (std::is_same_v<T, Pack>)
    return value;
  else
    return {value, Pack(0.0), Pack(0.0), Pack(0.0)};
}

}  // namespace vug::field
