// SPDX-License-Identifier: Apache-2.0
// Hyperbolic functions with bit-identical results on every machine, like those of maths.h.
#pragma once

namespace vug::maths {

/// Correct to about 2 ulp of the result.
double tanh(double x);
/// The inverse, for -1 < x < 1; infinite at -1 and 1, NaN beyond.
double atanh(double x);

}  // namespace vug::maths
