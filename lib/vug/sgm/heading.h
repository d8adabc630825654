// SPDX-License-Identifier: Apache-2.0
// The direction in which a shape continues the base: slopes and joints.
#pragma once

#include <vug/base/vec.h>

#include <optional>
#include <vector>

namespace vug::sgm {

/// The direction in which a glued shape continues the base. A vertical direction does not turn.
struct Heading {
  std::optional<double> slope;   ///< Radians above the horizontal; empty: that of the bond.
  std::vector<double> azimuths;  ///< Radians clockwise from north (-z) of joints, of which the
                                 ///< nearest is followed in either direction; empty: any.

  /// The direction (a unit vector) with its slope and azimuth replaced.
  Vec3d turned(const Vec3d& direction) const;
};

}  // namespace vug::sgm
