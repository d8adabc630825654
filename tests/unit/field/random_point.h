// SPDX-License-Identifier: Apache-2.0
// Random points in a cube.
#pragma once

#include <vug/base/rng.h>
#include <vug/base/vec.h>

namespace vug::field {

/// A point whose coordinates are uniform in [-reach, reach].
inline Vec3d random_point(RandomStream& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

}  // namespace vug::field
