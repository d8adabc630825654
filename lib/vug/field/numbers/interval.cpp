// SPDX-License-Identifier: Apache-2.0
#include <vug/base/vec.h>
#include <vug/field/numbers/interval.h>

#include <algorithm>
#include <limits>

namespace vug {
namespace {

constexpr double kEverything = std::numeric_limits<double>::infinity();

/// 0 * infinity is defined as 0: a bound times a zero factor is zero.
double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

}  // namespace

Interval operator*(Interval a, Interval b) {
  const double p[] = {product(a.lo, b.lo), product(a.lo, b.hi), product(a.hi, b.lo),
                      product(a.hi, b.hi)};
  return {*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
}

Interval operator/(Interval a, Interval b) {
  if (b.lo <= 0 && b.hi >= 0) return {-kEverything, kEverything};
  return a * Interval(1 / b.hi, 1 / b.lo);
}

Interval sin(Interval a) { return cos(a - Interval(0.5 * kPi)); }

Interval cos(Interval a) {
  if (!(a.width() < 2 * kPi)) return {-1, 1};
  const double first = maths::cos(a.lo), last = maths::cos(a.hi);
  Interval out(std::min(first, last), std::max(first, last));
  const double k = std::ceil(a.lo / kPi);
  for (double n = k; n * kPi <= a.hi; ++n)
    (std::fmod(std::fabs(n), 2) == 0 ? out.hi : out.lo) = std::fmod(std::fabs(n), 2) == 0 ? 1 : -1;
  return out;
}

Interval exp(Interval a) { return {maths::exp(a.lo), maths::exp(a.hi)}; }

Interval atan2(Interval y, Interval x) {
  if (x.lo <= 0 && y.lo <= 0 && y.hi >= 0) return {-kPi, kPi};  // The origin or the branch cut.
  const double corner[] = {maths::atan2(y.lo, x.lo), maths::atan2(y.lo, x.hi),
                           maths::atan2(y.hi, x.lo), maths::atan2(y.hi, x.hi)};
  return {*std::min_element(corner, corner + 4), *std::max_element(corner, corner + 4)};
}

}  // namespace vug
