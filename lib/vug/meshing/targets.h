// Where each vertex of the raw polygons should go.
#pragma once

#include <vug/meshing/faces.h>
#include <vug/meshing/polygonize.h>

namespace vug::meshing {

/// The places a vertex may go to.
struct Target {
  Vec3d crease;       ///< The point of the crease nearest to the vertex,
  Vec3d alternative;  ///< and the one nearest to the middle of the samples around.
  Vec3d surface;      ///< The nearest point of the surface.
  bool has_crease = false;
};

/// By vertex. `voxel` in metres; cells of the lattice through the origin hold one raw vertex each.
std::vector<Target> find_targets(const FaceMesh& raw, const field::Field& exact, double voxel,
                                 const PolygonizeOptions& options, Progress& progress);

}  // namespace vug::meshing
