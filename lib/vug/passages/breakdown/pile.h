// SPDX-License-Identifier: Apache-2.0
// The pile of blocks below a vault.
#pragma once

#include <vug/passages/breakdown/vault.h>

namespace vug::passages {

struct PileOptions {
  double floor = 0;                ///< Height y of the ground, metres.
  double repose = 34 * kPi / 180;  ///< Mean slope of piles, radians; that of a single pile of some
                                   ///< hundred blocks is within 2 degrees of it.
  double bulk = 1.4;               ///< Volume of the pile over that of the fallen rock.
  double broken = 0.8;             ///< Depth of the breaks of edges and corners, 0 to 1.
  uint64_t seed = 0;
};

struct Pile {
  std::vector<OrientedBox> blocks;  ///< At rest, before pieces broke off.
  std::vector<Polytope> broken;     ///< The part of each block that remains.
  double height = 0;                ///< Height of the cone that the pile fills, above the floor.
  double ridge = 0;                 ///< Half the length of the cone's level ridge, metres.
  Vec3d along{1, 0, 0};             ///< Horizontal direction of the ridge.
  Vec3d foot{0.0};                  ///< On the floor below the middle of the ridge.
  double slope = 0.7;               ///< Tangent of the angle of repose.

  /// The horizontal vector to a point from the nearest one of the ridge.
  Vec3d from_ridge(const Vec3d& p) const;
  /// The height of the cone above the floor at a point; 0 or less outside of it.
  double cone(const Vec3d& p) const;
  /// The volume below the tops of `blocks`, gaps included, in cubic metres, from a grid of columns.
  double volume() const;
};

/// The cone for the blocks of a vault, without blocks. Throws Error(bad_input) for options out of
/// range, and if the pile would reach the roof.
Pile pile_cone(const Vault& vault, const PileOptions& options);

/// Lets the blocks of a vault fall, in their order, onto a cone-shaped pile with the angle of
/// repose whose volume is `bulk` times that of the fallen rock. Each block falls where the pile
/// lacks most of the cone, and turns and slides as long as its centre descends; the landing is
/// exact, so blocks touch but do not overlap. Blocks that the cone has no room for are the fines in
/// the gaps. At last, pieces break off where blocks do not touch. Throws as pile_cone does.
Pile pile(const Vault& vault, const PileOptions& options);

/// The union of the broken blocks and, up to `fines` of the height of the cone (0 to 1; 0: none),
/// of the fine rubble between them.
field::Field pile_body(const Pile& pile, double floor, double fines);

/// The same for the pile of a vault, which is computed when a value is first needed. Throws as
/// pile_cone does.
field::Field breakdown_body(const Vault& vault, const PileOptions& options, double fines);

}  // namespace vug::passages
