// Hyperbolic functions with the same bits on every machine, as those of maths.h.
#pragma once

namespace vug::maths {

/// Correct to about 2 ulp of the result's size.
double tanh(double x);
/// The inverse, for -1 < x < 1; infinite at the ends, not a number beyond.
double atanh(double x);

}  // namespace vug::maths
