// SPDX-License-Identifier: Apache-2.0
// Logarithms and powers to the base 2 with the same bits on every machine, for bits of information
// and stops of light.
#pragma once

#include <vug/base/maths.h>

namespace vug::maths {

inline constexpr double kLn2 = 0.69314718055994530942;

inline double log2(double x) { return log(x) / kLn2; }
inline double exp2(double x) { return exp(x * kLn2); }

}  // namespace vug::maths
