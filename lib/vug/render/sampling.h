// SPDX-License-Identifier: Apache-2.0
// Mappings from uniform numbers in [0, 1)^2 to directions, in single precision and with the same
// bits on every machine.
#pragma once

#include <vug/render/vectors.h>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace vug::render {

struct SinCos {
  float sin, cos;
};

/// Sine and cosine of an angle in turns (1 = 360 degrees), |turns| <= 4; error below 1e-7: Taylor
/// polynomials after reduction to an eighth of a turn.
inline SinCos sincos_turns(float turns) {
  const float quarter = std::floor(4.0f * turns + 0.5f);
  const float x = (4.0f * turns - quarter) * (0.5f * kPif), xx = x * x;
  const float s =
      x * (1 + xx * (-1 / 6.0f + xx * (1 / 120.0f + xx * (-1 / 5040.0f + xx / 362880.0f))));
  const float c = 1 + xx * (-0.5f + xx * (1 / 24.0f + xx * (-1 / 720.0f + xx * (1 / 40320.0f))));
  // The quadrant is unpredictable, so no branch depends on it.
  const auto turn = static_cast<uint32_t>(static_cast<int>(quarter));
  const bool across = (turn & 1) != 0;
  const auto with_sign = [](float v, uint32_t sign) {
    return std::bit_cast<float>(std::bit_cast<uint32_t>(v) ^ (sign << 31));
  };
  return {with_sign(across ? c : s, turn >> 1 & 1), with_sign(across ? s : c, (turn + 1) >> 1 & 1)};
}

/// The angle of (x, y) in turns, [0, 1); error below 1e-7 (Abramowitz and Stegun 1964, 4.4.49).
inline float turns_of(float y, float x) {
  const float ax = std::fabs(x), ay = std::fabs(y), most = std::max(ax, ay);
  if (!(most > 0)) return 0;
  const float t = std::min(ax, ay) / most, tt = t * t;
  float polynomial = 0.0028662257f;
  for (const float c : {-0.0161657367f, 0.0429096138f, -0.0752896400f, 0.1065626393f,
                        -0.1420889944f, 0.1999355085f, -0.3333314528f, 1.0f})
    polynomial = polynomial * tt + c;
  float turns = t * polynomial * (0.5f / kPif);
  if (ay > ax) turns = 0.25f - turns;
  if (x < 0) turns = 0.5f - turns;
  if (y < 0) turns = 1 - turns;
  return turns < 1 ? turns : 0;
}

/// Uniform on the unit disk, preserving strata: Shirley and Chiu 1997 (cite shirley1997disk).
inline Vec2f sample_disk(const Vec2f& u) {
  const float a = 2 * u.x - 1, b = 2 * u.y - 1;
  if (a == 0 && b == 0) return {0, 0};
  const bool wide = std::fabs(a) > std::fabs(b);
  const float r = wide ? a : b, turn = 0.125f * ((wide ? b : a) / r);
  const SinCos sc = sincos_turns(wide ? turn : 0.25f - turn);
  return {r * sc.cos, r * sc.sin};
}

/// Local direction with density cos / pi on the upper hemisphere.
inline Vec3f sample_cosine_hemisphere(const Vec2f& u) {
  const Vec2f d = sample_disk(u);
  return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

/// 1 - cosine of an angle below 90 degrees, from its squared sine <= 1; exact for small angles.
inline float one_minus_cosine(float squared_sine) {
  return squared_sine / (1 + std::sqrt(std::max(0.0f, 1 - squared_sine)));
}

/// Direction at an angle from z given by 1 - cosine, which is exact for small angles; `turn` is the
/// azimuth as a fraction of a full turn.
inline Vec3f direction_off_axis(float one_minus_cosine, float turn) {
  const SinCos sc = sincos_turns(turn);
  const float sine = std::sqrt(std::max(0.0f, one_minus_cosine * (2 - one_minus_cosine)));
  return {sine * sc.cos, sine * sc.sin, 1 - one_minus_cosine};
}
inline Vec3f direction_at(float cosine, float turn) { return direction_off_axis(1 - cosine, turn); }

/// Uniform on the unit sphere; density 1 / (4 pi).
inline Vec3f sample_sphere(const Vec2f& u) { return direction_at(1 - 2 * u.x, u.y); }

}  // namespace vug::render
