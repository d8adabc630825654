// SPDX-License-Identifier: Apache-2.0
// Base-2 logarithms. Code lengths are in bits; probabilities are natural logarithms.
#pragma once

#include <vug/base/log2.h>

namespace vug::inference {

using maths::kLn2, maths::log2;

}  // namespace vug::inference
