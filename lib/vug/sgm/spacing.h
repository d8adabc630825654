// SPDX-License-Identifier: Apache-2.0
// Internal to Growth: the distance of a new shape from earlier ones.
#pragma once

#include <vug/sgm/growth.h>

namespace vug::sgm {

/// Placements, and the boxes of those whose shapes the solid contains.
struct PlacedShapes {
  const std::vector<Placement>& placements;
  const BoxIndex& boxes;
};

/// Whether the solid contains the shape: cuts remove theirs.
bool adds(const Placement& placement);

/// The index of the placement on whose surface the point lies, the last one of several; -1: none.
/// `tolerance` in metres.
int owner_at(const PlacedShapes& placed, const Vec3d& point, double tolerance);

/// Whether the middle of the shape, or one of 26 points of its surface, is nearer than `apart`
/// metres to an earlier shape other than the owner of its bond, the owner's own owner and the
/// shapes that are glued to the owner. The ends of a connecting shape are both owners.
bool is_too_near(const Placement& shape, const PlacedShapes& placed, double apart);

}  // namespace vug::sgm
