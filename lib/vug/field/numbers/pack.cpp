// SPDX-License-Identifier: Apache-2.0
#include <vug/field/numbers/pack.h>

#include <initializer_list>

namespace vug::field {

void sincos(Pack x, Pack& sine, Pack& cosine) {
  const Pack magnitude = abs(x);
  // Nearest multiple of pi/2, as a number and as its last two bits.
  const Pack quarter = floor(magnitude * Pack(0.6366197723675814) + Pack(0.5));
  const __m256i q = _mm256_cvtps_epi32(quarter.v);
  const Pack z =
      ((magnitude - quarter * Pack(1.5703125)) - quarter * Pack(4.837512969970703125e-4)) -
      quarter * Pack(7.549789948768648e-8);
  const Pack zz = z * z;
  const Pack s =
      z +
      z * zz * ((Pack(-1.9515295891e-4) * zz + Pack(8.3321608736e-3)) * zz - Pack(1.6666654611e-1));
  const Pack c = Pack(1.0) - Pack(0.5) * zz +
                 zz * zz *
                     ((Pack(2.443315711809948e-5) * zz - Pack(1.388731625493765e-3)) * zz +
                      Pack(4.166664568298827e-2));
  auto bit = [&](int value, __m256i from) {
    const __m256i mask = _mm256_set1_epi32(value);
    return PackMask{_mm256_castsi256_ps(_mm256_cmpeq_epi32(_mm256_and_si256(from, mask), mask))};
  };
  const PackMask odd = bit(1, q), second = bit(2, q);
  const PackMask flip_cos = bit(2, _mm256_add_epi32(q, _mm256_set1_epi32(1)));
  const Pack sin_value = select(odd, c, s), cos_value = select(odd, s, c);
  const Pack signed_sine = select(second, -sin_value, sin_value);
  sine = select(x < Pack(0.0), -signed_sine, signed_sine);
  cosine = select(flip_cos, -cos_value, cos_value);
}

Pack exp(Pack x) {
  const Pack clamped = min(max(x, Pack(-87.0)), Pack(88.0));
  const Pack n = floor(clamped * Pack(1.44269504088896341) + Pack(0.5));
  const Pack z = (clamped - n * Pack(0.693359375)) + n * Pack(2.12194440e-4);
  Pack p = Pack(1.9875691500e-4);
  for (const double coefficient :
       {1.3981999507e-3, 8.3334519073e-3, 4.1665795894e-2, 1.6666665459e-1, 5.0000001201e-1})
    p = p * z + Pack(coefficient);
  const Pack mantissa = p * z * z + z + Pack(1.0);
  const __m256i power =
      _mm256_slli_epi32(_mm256_add_epi32(_mm256_cvtps_epi32(n.v), _mm256_set1_epi32(127)), 23);
  return select(x < Pack(-87.0), Pack(0.0), mantissa * Pack(_mm256_castsi256_ps(power)));
}

Pack atan2(Pack y, Pack x) {
  const Pack ax = abs(x), ay = abs(y);
  const Pack big = max(ax, ay), small = min(ax, ay);
  const Pack ratio = select(big > Pack(0.0), small / max(big, Pack(1e-37)), Pack(0.0));
  // Beyond tan(pi/8) the argument is first rotated by pi/4.
  const PackMask beyond = ratio > Pack(0.4142135623730950);
  const Pack t = select(beyond, (ratio - Pack(1.0)) / (ratio + Pack(1.0)), ratio);
  const Pack z = t * t;
  const Pack p =
      (((Pack(8.05374449538e-2) * z - Pack(1.38776856032e-1)) * z + Pack(1.99777106478e-1)) * z -
       Pack(3.33329491539e-1)) *
          z * t +
      t;
  Pack angle = p + select(beyond, Pack(0.78539816339744831), Pack(0.0));
  angle = select(ay > ax, Pack(1.5707963267948966) - angle, angle);
  angle = select(x < Pack(0.0), Pack(3.14159265358979324) - angle, angle);
  return select(y < Pack(0.0), -angle, angle);
}

}  // namespace vug::field
