// SPDX-License-Identifier: Apache-2.0
// The plane on which a body comes to rest: the linear programme of its contacts.
#pragma once

#include <array>
#include <vector>

namespace vug::mesh {

/// A point where a body may touch the ground, in metres.
struct Gap {
  double x = 0, z = 0;  ///< Horizontal offset from the centre of mass.
  double height = 0;    ///< The height of the body above the ground.
  double ground = 0;    ///< Height y of the ground.
};

/// What remains of the gaps if the body descends by drop + slope_x x + slope_z z at each point.
struct SupportPlane {
  double drop = 0;
  double slope_x = 0, slope_z = 0;
  /// The gaps that this closes; their triangle contains the centre of mass, so the body rests on
  /// them. -1: the limit of the slope was reached instead of a contact.
  std::array<int, 3> contacts{-1, -1, -1};

  bool is_supported() const { return contacts[0] >= 0 && contacts[1] >= 0 && contacts[2] >= 0; }
};

/// The largest drop of the centre of mass that keeps all gaps at 0 or more, for small slopes, by
/// the dual simplex method: the potential energy of a body is least there. `reach` is a length
/// above the distance of all gaps from the centre; the slope is at most about twice `limit`.
SupportPlane support_plane(const std::vector<Gap>& gaps, double reach, double limit);

}  // namespace vug::mesh
