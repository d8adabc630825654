// Inside volume/ only: the walk from a cube of the lattice down to the blocks that hold surface.
#pragma once

#include <vug/base/progress.h>
#include <vug/volume/block.h>
#include <vug/volume/grid_access.h>

namespace vug::volume {

struct OctreeTask {
  NarrowBand band;
  int64_t low[3] = {0, 0, 0};  ///< Lattice points beyond low..high are out of the band.
  int64_t high[3] = {-1, -1, -1};
};

/// The cube around low..high from which the walk starts: a power of two in size, 128 at least,
/// aligned to min(size, 4096), so that its parts are nodes of the tree.
Cell root_around(const OctreeTask& walk);

/// The level set's grid, without name and metadata; the same for any number of threads.
std::shared_ptr<openvdb::GridBase> build(const field::Field& field, const OctreeTask& walk,
                                         Progress& progress);

}  // namespace vug::volume
