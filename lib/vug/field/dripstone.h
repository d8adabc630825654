// SPDX-License-Identifier: Apache-2.0
// Dripstone in caves: the search for the positions of drips, and the speleothems that grow there.
#pragma once

#include <vug/field/noise.h>

#include <optional>
#include <vector>

namespace vug::field {

/// All lengths are in metres.
struct DripOptions {
  Vec3d from{-5, -5, -5}, to{5, 5, 5};  ///< Box in which roofs are searched.
  double spacing = 0.8;                 ///< Mean distance between possible drips.
  double length = 1.5;                  ///< Length of the longest stalactites.
  double girth = 0.12;                  ///< Radius at the root as a fraction of the length.
  double tip = 0.03;                    ///< Radius of every tip.
  double stalagmites = 0.6;             ///< Fraction of the drips with a stalagmite below, 0..1.
  double root = 0.3;                    ///< Distance over which roots blend into the rock.
  std::optional<Noise> where;           ///< Density mask: no drips at -1, all drips at 1.
  int seed = 1;
};

/// A drip: a point of a roof and the point of the floor vertically below it.
struct Drip {
  Vec3d roof, floor;
  double stalactite = 0;  ///< Length.
  double stalagmite = 0;  ///< Height; 0 for none.
  bool column = false;    ///< The two have met.
};

/// Finds all drips inside the box, in lattice order. Air is where `rock` is positive; at roofs the
/// gradient of the rock points down, at floors up.
std::vector<Drip> find_drips(const Field& rock, const DripOptions& options);

/// The speleothems of `drips`, without the rock.
Field dripstone(const std::vector<Drip>& drips, const DripOptions& options);

/// Bounds of the speleothems of all drips that rock with these bounds can have.
Box3d dripstone_bounds(const Box3d& rock, const DripOptions& options);

}  // namespace vug::field
