// SPDX-License-Identifier: Apache-2.0
// Uniform random floats in [0, 1) for the sampling functions of kinds.
#pragma once

#include <vug/base/rng.h>
#include <vug/base/vec.h>

namespace vug::render {

inline float uniform(RandomStream& random) {
  return static_cast<float>(random.bits() >> 8) * 0x1p-24f;
}

inline Vec2f uniform_2d(RandomStream& random) {
  const float x = uniform(random);
  return {x, uniform(random)};
}

}  // namespace vug::render
