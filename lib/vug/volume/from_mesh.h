// SPDX-License-Identifier: Apache-2.0
// Conversion of a closed mesh to a level set.
#pragma once

#include <vug/base/progress.h>
#include <vug/mesh/mesh.h>
#include <vug/volume/level_set.h>

namespace vug::volume {

struct FromMeshOptions {
  double voxel = 0.1;       ///< Edge of a voxel, metres.
  double half_width = 3;    ///< Half-width of the band in voxels; at least 3.
  uint64_t max_memory = 0;  ///< Memory limit in bytes; 0: the available memory of the machine.
};

/// Signed distances to the triangles. A point is outside if it is reachable from far away, so
/// intersecting surfaces, for example of moved meshes, bound one solid. The exception are cavities:
/// connected surfaces inside the solid whose normals point into the space that they enclose (all
/// normals count as reversed if those of the largest surface point inwards). The lattice is that of
/// `voxelize`. A mesh without triangles gives an empty grid. The result has the same bytes for any
/// number of threads. Throws Error(bad_input) for an open mesh, which does not bound a solid, and
/// for lattice points beyond 32-bit indices; Error(too_large) before the work starts;
/// Error(cancelled).
LevelSet from_mesh(const mesh::Mesh& mesh, const FromMeshOptions& options,
                   Progress& progress = Progress::none());

/// Approximate memory requirement in bytes.
double from_mesh_bytes(double area, const FromMeshOptions& options);

}  // namespace vug::volume
