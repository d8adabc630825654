// SPDX-License-Identifier: Apache-2.0
#include <vug/base/hyperbolic.h>
#include <vug/base/maths.h>

#include <cmath>

namespace vug::maths {

double tanh(double x) {
  const double size = std::fabs(x);
  if (size < 0.3) {  // Lambert's continued fraction, because exponentials would cancel
    const double xx = x * x;
    double f = 15;
    for (int k = 13; k >= 1; k -= 2) f = k + xx / f;
    return x / f;
  }
  const double result = 1 - 2 / (exp(2 * size) + 1);
  return x < 0 ? -result : result;
}

double atanh(double x) {
  if (std::fabs(x) < 0.17) {  // the series reaches 1 ulp at x^21
    const double xx = x * x;
    double p = 1.0 / 21;
    for (int k = 19; k >= 3; k -= 2) p = p * xx + 1.0 / k;
    return x + x * xx * p;
  }
  return 0.5 * log((1 + x) / (1 - x));
}

}  // namespace vug::maths
