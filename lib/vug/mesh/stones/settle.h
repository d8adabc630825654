// SPDX-License-Identifier: Apache-2.0
// Lets a body turn and descend until it rests on three contacts around its centre of mass.
#pragma once

#include <vug/mesh/stones/stone_shape.h>
#include <vug/mesh/stones/support_plane.h>

#include <functional>

namespace vug::mesh {

/// Appends the gaps between a stone in a pose and the ground below it.
using GapFunction = std::function<void(const StonePose&, std::vector<Gap>&)>;

/// A stone at rest.
struct Rest {
  StonePose pose;
  std::array<Vec3d, 3> contacts;  ///< Points of the ground; the centre of mass is above them.

  /// Twice the area of the triangle of the contacts, along its normal, which points up.
  Vec3d contact_area() const;
};

/// A local minimum of the height of the centre of mass over all rotations, without a horizontal
/// motion of the centre: each step turns the stone by the support_plane of its gaps, and drops it
/// until it touches the ground. The ground may be rough. All three contacts are within `tolerance`
/// of the stone. Returns nothing if the stone has no ground below it or finds no such minimum.
std::optional<Rest> settle(StonePose pose, double reach, double tolerance, const GapFunction& gaps);

}  // namespace vug::mesh
