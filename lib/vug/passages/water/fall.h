// SPDX-License-Identifier: Apache-2.0
// Water that falls freely from a lip, or slides down rock that is less steep than its parabola.
#pragma once

#include <vug/passages/water/polytopes.h>

#include <vector>

namespace vug::passages {

/// A point on the way of falling water, at the height of water that slides on the bed.
struct FallPoint {
  Vec3d position{0.0};
  Vec3d right{1, 0, 0};  ///< Horizontal, across the passage; a unit vector.
};

struct Fall {
  std::vector<FallPoint> way;  ///< From the lip to the foot, and some way beyond it.
  double foot = 0;             ///< Height of the water below.
  double discharge = 0.05;     ///< m^3/s.
  double width = 1;            ///< Metres.
  double thickness = 0.1;      ///< Metres, at least.
};

/// Appends the sheet of water. It leaves the lip with the critical velocity sqrt(g d), d =
/// (q^2 / g)^(1/3) for the discharge q per width (chow1959, section 4-3), and follows
/// y = -g x^2 / (2 v^2), or the bed where that is higher, to 0.1 m below the foot. Its thickness is
/// q over the speed of free fall.
void append_fall(const Fall& fall, std::vector<Polytope>& out);

}  // namespace vug::passages
