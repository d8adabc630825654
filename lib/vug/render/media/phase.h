// SPDX-License-Identifier: Apache-2.0
// The Henyey-Greenstein phase function (henyey1941).
#pragma once

#include <vug/render/sampling.h>

namespace vug::render {

/// `g`: mean cosine between the two directions of travel, -1 < g < 1; in 1/sr.
inline float henyey_greenstein(float g, float cosine) {
  const float d = 1 + g * g - 2 * g * cosine;
  return (1 - g * g) / (4 * kPif * d * std::sqrt(d));
}

/// Samples a new direction of travel with that density.
inline Vec3f sample_henyey_greenstein(float g, const Vec3f& travel, const Vec2f& u) {
  float cosine = 1 - 2 * u.x;
  if (std::fabs(g) > 1e-3f) {
    const float q = (1 - g * g) / (1 + g - 2 * g * u.x);
    cosine = std::clamp((1 + g * g - q * q) / (2 * g), -1.0f, 1.0f);
  }
  return Frame(travel).to_world(direction_at(cosine, u.y));
}

}  // namespace vug::render
