// Moves the vertices of raw polygons onto the exact surface, without folding any polygon.
#pragma once

#include <vug/meshing/faces.h>
#include <vug/meshing/polygonize.h>

namespace vug::meshing {

/// Where the vertices went.
struct Polished {
  std::vector<Vec3d> points;
  std::vector<char> on_crease;  ///< By vertex.
  size_t backed_off = 0;
};

/// `voxel` in metres; cells of the lattice through the origin hold one raw vertex each.
Polished polish(const FaceMesh& raw, const field::Field& exact, double voxel,
                const PolygonizeOptions& options, Progress& progress);

}  // namespace vug::meshing
