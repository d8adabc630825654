// From a level set to a triangle mesh whose vertices lie on the field it was sampled from.
// OpenVDB's volume-to-mesh gives a closed surface with one vertex in a cell, but cuts creases by
// up to 0.67 voxel and leaves vertices where trilinear interpolation puts them. Vertices are
// moved onto the exact zero set by Newton steps, and where the field's gradients around a vertex
// disagree (a crease) to the point that fits all tangent planes (ju2002).
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>
#include <vug/mesh/mesh.h>
#include <vug/volume/level_set.h>

namespace vug::meshing {

struct PolygonizeOptions {
  double adaptivity = 0;     ///< 0..1: how far flat regions are merged into larger polygons.
  bool polish = true;        ///< Move vertices onto the exact field.
  bool creases = true;       ///< Keep edges and corners sharp.
  double crease_angle = 25;  ///< Degrees between gradients around a vertex that make a crease.
  double max_move = 1;       ///< Furthest a vertex may go, in voxels; creases add up to 0.25.
  bool normals = true;       ///< Exact gradients; on creases the mean of the triangles around.
};

/// How well the polish went. Lengths are in voxels.
struct PolishReport {
  size_t crease_vertices = 0;
  size_t shortened_moves = 0;  ///< Moves shortened because they would fold a polygon.
  double rms_residual = 0;     ///< Distance of vertices from the exact surface, to first order.
  double max_residual = 0;
  double max_move = 0;
};

struct PolygonizeResult {
  mesh::Mesh mesh;
  PolishReport report;
};

/// `exact` is the field that the level set samples, on the lattice through the origin; without
/// it vertices stay where OpenVDB puts them and normals come from the triangles. Fields are asked
/// in single precision where that places the surface to 1e-3 voxel, else in double. The mesh is
/// closed where the level set is, faces outwards, and has the same bytes for any number of threads.
/// Walls thinner than a voxel or two, and the tips of edges sharper than about 60 degrees, are lost
/// in the level set already. Error(cancelled).
PolygonizeResult polygonize(const volume::LevelSet& level_set, const field::Field* exact,
                            const PolygonizeOptions& options = {},
                            Progress& progress = Progress::none());

}  // namespace vug::meshing
