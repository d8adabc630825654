// SPDX-License-Identifier: Apache-2.0
// Target positions for the vertices of the raw polygons.
#pragma once

#include <vug/meshing/faces.h>
#include <vug/meshing/polygonize.h>

namespace vug::meshing {

class PolishPasses;  // See polish_passes.h.

/// The positions that a vertex may move to.
struct Target {
  Vec3d crease;  ///< The point of the crease nearest to the vertex.
  Vec3d
      alternative;  ///< The point of the crease nearest to the centroid of the surrounding samples.
  Vec3d surface;    ///< The nearest point of the surface.
  bool has_crease = false;
};

/// One target per vertex. `voxel` is in metres; each cell of the lattice through the origin
/// contains one raw vertex.
std::vector<Target> find_targets(const FaceMesh& raw, const field::Field& exact, double voxel,
                                 const PolygonizeOptions& options, const PolishPasses& passes,
                                 Progress& progress);

}  // namespace vug::meshing
