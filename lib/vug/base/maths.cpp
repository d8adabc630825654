// SPDX-License-Identifier: Apache-2.0
// Coefficients: the minimax polynomials of the Cephes library (S. L. Moshier, 1989), double
// precision; argument reduction by Cody and Waite (1980).
#include <vug/base/maths.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace vug::maths {
namespace {

constexpr double kPio4High = 7.85398125648498535156e-1;
constexpr double kPio4Mid = 3.77489470793079817668e-8;
constexpr double kPio4Low = 2.69515142907905952645e-15;

double sin_kernel(double z) {
  const double zz = z * z;
  double p = 1.58962301576546568060e-10;
  p = p * zz - 2.50507477628578072866e-8;
  p = p * zz + 2.75573136213857245213e-6;
  p = p * zz - 1.98412698295895385996e-4;
  p = p * zz + 8.33333333332211858878e-3;
  p = p * zz - 1.66666666666666307295e-1;
  return z + z * zz * p;
}

double cos_kernel(double z) {
  const double zz = z * z;
  double p = -1.13585365213876817300e-11;
  p = p * zz + 2.08757008419747316778e-9;
  p = p * zz - 2.75573141792967388112e-7;
  p = p * zz + 2.48015872888517045348e-5;
  p = p * zz - 1.38888888888730564116e-3;
  p = p * zz + 4.16666666666665929218e-2;
  return 1.0 - 0.5 * zz + zz * zz * p;
}

/// |x| = z + octant * pi/4 with octant even and |z| <= pi/4.
double reduce(double x, long long& octant) {
  octant = static_cast<long long>(x / (0.25 * 3.14159265358979323846));
  if (octant & 1) ++octant;
  const double y = static_cast<double>(octant);
  return ((x - y * kPio4High) - y * kPio4Mid) - y * kPio4Low;
}

double atan_kernel(double x) {  // |x| <= 0.66
  const double z = x * x;
  double p = -8.750608600031904122785e-1;
  p = p * z - 1.615753718733365076637e1;
  p = p * z - 7.500855792314704667340e1;
  p = p * z - 1.228866684490136173410e2;
  p = p * z - 6.485021904942025371773e1;
  double q = z + 2.485846490142306297962e1;
  q = q * z + 1.650270098316988542046e2;
  q = q * z + 4.328810604912902668951e2;
  q = q * z + 4.853903996359136964868e2;
  q = q * z + 1.945506571482613964425e2;
  return x + x * z * (p / q);
}

double atan_positive(double x) {
  constexpr double kTan3Pio8 = 2.41421356237309504880;
  if (x > kTan3Pio8) return 1.57079632679489661923 + atan_kernel(-1.0 / x);
  if (x > 0.66) return 0.78539816339744830962 + atan_kernel((x - 1.0) / (x + 1.0));
  return atan_kernel(x);
}

}  // namespace

double sin(double x) {
  long long octant = 0;
  const double z = reduce(std::fabs(x), octant);
  const long long quarter = (octant >> 1) & 3;
  double value = (quarter & 1) ? cos_kernel(z) : sin_kernel(z);
  if (quarter & 2) value = -value;
  return x < 0 ? -value : value;
}

double cos(double x) {
  long long octant = 0;
  const double z = reduce(std::fabs(x), octant);
  const long long quarter = (octant >> 1) & 3;
  const double value = (quarter & 1) ? sin_kernel(z) : cos_kernel(z);
  return quarter == 1 || quarter == 2 ? -value : value;
}

double tan(double x) { return sin(x) / cos(x); }

double exp(double x) {
  if (x > 709.7) return std::numeric_limits<double>::infinity();
  if (x < -745.2) return 0;
  const double n = std::floor(1.4426950408889634073599 * x + 0.5);
  double z = x - n * 6.93145751953125e-1;
  z -= n * 1.42860682030941723212e-6;
  const double zz = z * z;
  double p = 1.26177193074810590878e-4;
  p = p * zz + 3.02994407707441961300e-2;
  p = (p * zz + 9.99999999999999999910e-1) * z;
  double q = 3.00198505138664455042e-6;
  q = q * zz + 2.52448340349684104192e-3;
  q = q * zz + 2.27265548208155028766e-1;
  q = q * zz + 2.00000000000000000005;
  const double part = 1.0 + 2.0 * (p / (q - p));
  const auto power = static_cast<int>(n);
  // Replaces the slow std::ldexp if 2^n and the product are normal numbers.
  return std::abs(power) <= 1020
             ? part * std::bit_cast<double>(static_cast<uint64_t>(power + 1023) << 52)
             : std::ldexp(part, power);
}

double log(double x) {
  if (!(x > 0)) return x == 0 ? -std::numeric_limits<double>::infinity() : std::nan("");
  if (std::isinf(x)) return x;
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.70710678118654752440) {
    m *= 2;
    --exponent;
  }
  // log m = 2 atanh(s), s = (m-1)/(m+1), |s| <= 0.1716: the series reaches 1 ulp at s^21.
  const double s = (m - 1) / (m + 1), ss = s * s;
  double p = 1.0 / 21;
  for (int k = 19; k >= 3; k -= 2) p = p * ss + 1.0 / k;
  const double e = exponent;
  return e * 6.93147180369123816490e-1 +
         (2 * s + (2 * s * ss * p + e * 1.90821492927058770002e-10));
}

double atan2(double y, double x) {
  constexpr double pi = 3.14159265358979323846;
  const double ax = std::fabs(x), ay = std::fabs(y);
  double angle = 0;
  if (ax > 0 || ay > 0)
    angle = ay <= ax ? atan_positive(ay / ax) : 0.5 * pi - atan_positive(ax / ay);
  if (x < 0) angle = pi - angle;
  return y < 0 ? -angle : angle;
}

double acos(double x) {
  const double c = x < -1 ? -1 : x > 1 ? 1 : x;
  return atan2(std::sqrt((1 - c) * (1 + c)), c);
}

}  // namespace vug::maths
