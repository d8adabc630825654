// A level set of a closed mesh.
#pragma once

#include <vug/base/progress.h>
#include <vug/mesh/mesh.h>
#include <vug/volume/level_set.h>

namespace vug::volume {

struct FromMeshOptions {
  double voxel = 0.1;       ///< Edge of a voxel, metres.
  double half_width = 3;    ///< Half the band, in voxels; 3 at least.
  uint64_t max_memory = 0;  ///< Bytes that the work may take; 0: what the machine has available.
};

/// Distances to the triangles; outside is what can be reached from far away, so that surfaces which
/// cross, as those of moved meshes may, bound one solid. Lattice points lie as those of `voxelize`.
/// A mesh without triangles gives an empty grid. The same bytes for any number of threads.
/// Error(bad_input) for an open mesh, which bounds nothing, and for lattice points beyond 32-bit
/// indices; Error(too_large) before the work starts; Error(cancelled).
LevelSet from_mesh(const mesh::Mesh& mesh, const FromMeshOptions& options,
                   Progress& progress = Progress::none());

/// Bytes that this will take, about.
double from_mesh_bytes(double area, const FromMeshOptions& options);

}  // namespace vug::volume
