// SPDX-License-Identifier: Apache-2.0
// What makes turned solids about the y axis uneven.
#pragma once

#include <vug/base/rng.h>
#include <vug/field/field.h>

namespace vug::field {

/// Vertical ribs: the surface moves along its normal by up to +-`depth` metres, by the sum of two
/// waves around the axis. Nearer to the axis than `radius` they fade out.
struct Flutes {
  int count = 12;
  double depth = 0.01;
  double radius = 0.1;
};
Field fluted(const Field& turned, const Flutes& flutes, RandomKey key);

/// Moves horizontal slices by `offset`, which has no y, times a factor that depends on the height.
enum class BendProfile {
  foot,   ///< From 1 at the height `from` to 0 at `to`, as (1 - t)^2: the apex stays plumb.
  joint,  ///< From 1 to 0, smooth at both ends: below is another axis than above.
};
struct Bend {
  BendProfile profile = BendProfile::foot;
  Vec3d offset{0.0};
  double from = 0, to = 1;  ///< Heights in metres.
};
Field bent(const Field& turned, const Bend& bend);

}  // namespace vug::field
