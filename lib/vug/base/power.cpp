// SPDX-License-Identifier: Apache-2.0
// Powers with an error of at most 0.55 units in the last place: they are printed in texts and
// compared digit by digit with results of other programs. The logarithm and the remainder of the
// exponent are represented as sums of two numbers (dekker1971).
#include <vug/base/maths.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace vug::maths {
namespace {

constexpr double kLn2High = 6.93147180369123816490e-1;  // times a whole number below 2^21 exact
constexpr double kLn2Low = 1.90821492927058770002e-10;

/// high + low, where |low| is at most half a unit in the last place of high.
struct DoubleDouble {
  double high, low;
};

/// The exact sum for |a| >= |b| or a = 0.
DoubleDouble sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

DoubleDouble product(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

/// The logarithm of a normal x > 0, with a relative error of 2^-62.
DoubleDouble log_of(double x) {
  const auto bits = std::bit_cast<uint64_t>(x);
  int64_t exponent = static_cast<int64_t>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0xFFFFFFFFFFFFF) | 0x3FF0000000000000);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  // log m = 2 atanh(s) = 2 (s + s^3/3 + s^5/5 + ...), s = (m-1)/(m+1), |s| <= 0.1716.
  const double top = m - 1;
  const DoubleDouble under = m > 1 ? sum(m, 1) : sum(1, m);
  const double inverse = 1 / under.high;
  const double s = top * inverse;
  const double s_low = (std::fma(-s, under.high, top) - s * under.low) * inverse;
  const DoubleDouble square = product(s, s);
  const double z = square.high;
  double p = 0;
  for (const double odd : {23., 21., 19., 17., 15., 13., 11., 9., 7., 5.}) p = p * z + 1 / odd;
  const DoubleDouble cube = product(s, z);
  const double cube_low = cube.low + s * square.low + 3 * z * s_low;
  const double third = cube.high * (1.0 / 3);
  const double third_low = (std::fma(-3.0, third, cube.high) + cube_low) * (1.0 / 3);
  const DoubleDouble first = sum(2 * s, 2 * third);
  const double low = first.low + 2 * (s_low + third_low + cube.high * z * p);
  if (exponent == 0) return sum(first.high, low);
  const auto n = static_cast<double>(exponent);
  const DoubleDouble tail = product(n, kLn2Low);
  const DoubleDouble all = sum(n * kLn2High, first.high);
  const DoubleDouble more = sum(all.high, tail.high);
  return sum(more.high, all.low + more.low + low + tail.low);
}

double exp_of(DoubleDouble x) {
  if (x.high > 709.79) return std::numeric_limits<double>::infinity();
  if (x.high < -745.2) return 0;
  const double n = std::floor(1.4426950408889634 * x.high + 0.5);
  const double most = std::fma(n, -kLn2High, x.high);  // exact
  const DoubleDouble step = product(n, -kLn2Low);
  DoubleDouble r =
      std::fabs(most) > std::fabs(step.high) ? sum(most, step.high) : sum(step.high, most);
  r = sum(r.high, r.low + (step.low + x.low));
  // 1 + z + z^2/2 separately, z^3/6 + ... z^13/13! in one number.
  const double z = r.high;
  const DoubleDouble square = product(z, z);
  double p = 0;
  for (const double factorial : {6227020800.0, 479001600.0, 39916800.0, 3628800.0, 362880.0,
                                 40320.0, 5040.0, 720.0, 120.0, 24.0, 6.0})
    p = p * z + 1 / factorial;
  const DoubleDouble one = sum(1, z), two = sum(one.high, 0.5 * square.high);
  const double rest = square.high * z * p + 0.5 * square.low + r.low * (1 + z);
  const double out = two.high + (two.low + one.low + rest);
  const auto power = static_cast<int>(n);
  if (power < -1000 || power > 1000) return std::ldexp(out, power);  // perhaps not normal
  return out * std::bit_cast<double>(static_cast<uint64_t>(power + 1023) << 52);
}

}  // namespace

double pow(double base, double exponent) {
  if (exponent == 0) return 1;
  if (base == 0) return exponent > 0 ? 0 : std::numeric_limits<double>::infinity();
  if (!(base >= std::numeric_limits<double>::min()) || std::isinf(base) || !std::isfinite(exponent))
    return exp(exponent * log(base));
  const DoubleDouble log = log_of(base);
  const DoubleDouble all = product(exponent, log.high);
  return exp_of({all.high, all.low + exponent * log.low});
}

}  // namespace vug::maths
