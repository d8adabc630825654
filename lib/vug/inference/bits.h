// SPDX-License-Identifier: Apache-2.0
// Base-2 logarithms. Code lengths are in bits; probabilities are natural logarithms.
#pragma once

#include <vug/base/maths.h>

namespace vug::inference {

constexpr double kLn2 = 0.69314718055994530942;

inline double log2(double x) { return maths::log(x) / kLn2; }

}  // namespace vug::inference
