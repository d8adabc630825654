// SPDX-License-Identifier: Apache-2.0
// The free space of a body in the air of a level set, e.g. of a person who walks through a cave.
#pragma once

#include <vug/base/progress.h>
#include <vug/volume/level_set.h>

#include <cstdint>
#include <vector>

namespace vug::volume {

/// An upright capsule: a cylinder with half a sphere at either end.
struct UprightCapsule {
  double diameter = 0.4;  ///< Metres.
  double height = 1.8;    ///< Metres with both ends; at least the diameter.
};

struct ClearanceOptions {
  UprightCapsule body{};
  /// A point belongs to the nearest place at which the body has room, within this distance in
  /// metres between the point and the body's centre.
  double reach = 2;
  uint64_t max_memory = 0;  ///< Bytes; 0: no limit.
};

/// For each point the region of free places around it: an index from 0, or -1 if no place is within
/// reach. The body can move between two points if their regions are the same. It is free to float,
/// stays upright, and moves on a lattice of a quarter of its diameter, on which a gap counts if it
/// is wider than the body by one step. Only places in the box of the level set's band count. Throws
/// Error(bad_input) for a body that is not finite, not positive, or less high than wide,
/// Error(too_large) for a lattice beyond the memory, and Error(cancelled).
std::vector<int> free_regions(const LevelSet& rock, const std::vector<Vec3d>& points,
                              const ClearanceOptions& options,
                              Progress& progress = Progress::none());

}  // namespace vug::volume
