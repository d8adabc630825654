// SPDX-License-Identifier: Apache-2.0
// Terraces of rimstone pools on a sloping floor, as a function of the height of the floor.
#pragma once

#include <vug/field/field.h>
#include <vug/field/noise.h>

namespace vug::field {

/// The floor falls from pool to pool by `height`: pool k has the level k `height`. Metres.
struct RimstoneForm {
  double height = 0.1;
  double depth = 0.5;  ///< Depth of the pools in heights.
};

/// The height of the terraced floor where that of the smooth floor is `u` heights, as a multiple of
/// the height: a crest at each whole number, below it the pool's inner wall, its bed, and the steep
/// outer face of the dam above. It is continuous, and smooth but for the crests.
template <class T>
T terrace(const T& u, double depth);
/// The height of the water in the pools: whole numbers, and inside the dams between them below the
/// surface of the rock.
template <class T>
T terrace_water(const T& u, double depth);

/// Shares of a pool's height of smooth floor: the inner wall ends, the outer face begins.
inline constexpr double kInnerWall = 0.3, kOuterFace = 0.75;
/// The cosine of the floors for which the places of the crests are exact: 14 degrees. Their levels
/// are exact on all.
inline constexpr double kTerraceCosine = 0.97;

template <class T>
T terrace_step(const T& t) {
  const T x = clamp(t, T(0.0), T(1.0));
  return x * x * (T(3.0) - T(2.0) * x);
}

template <class T>
T terrace(const T& u, double depth) {
  const T level = floor(u), f = u - level;
  return level - T(depth) * terrace_step(f * T(1 / kInnerWall)) +
         T(1 + depth) * terrace_step((f - T(kOuterFace)) * T(1 / (1 - kOuterFace)));
}

template <class T>
T terrace_water(const T& u, double depth) {
  const T level = floor(u),
          t = clamp((u - level - T(kOuterFace)) * T(1 / (1 - kOuterFace)), T(0.0), T(1.0));
  // Below the face by a parabola that vanishes at both of its ends.
  const T face = T(1 + depth) * terrace_step(t) - T(depth) - t * (T(1.0) - t) * T(0.2);
  return level + max(face, T(0.0));
}

}  // namespace vug::field
