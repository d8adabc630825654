// SPDX-License-Identifier: Apache-2.0
// Transcendental functions with bit-identical results on every machine, so that geometry is
// reproducible: the C library selects different code paths on different processors. All are correct
// to about 1 ulp of the result for |x| up to 1e5 (sin, cos) and over the whole range (exp, log).
#pragma once

namespace vug::maths {

/// x in radians.
double sin(double x);
double cos(double x);
double exp(double x);
double log(double x);
/// Angle of (x, y) in radians, in [-pi, pi].
double atan2(double y, double x);
double acos(double x);
double tan(double x);
double pow(double base, double exponent);

}  // namespace vug::maths
