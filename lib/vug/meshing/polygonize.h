// SPDX-License-Identifier: Apache-2.0
// Polygonization of a level set into a triangle mesh with its vertices on the sampled field.
// OpenVDB's volume-to-mesh gives a closed surface with one vertex per cell, but cuts creases by up
// to 0.67 voxel and places vertices by trilinear interpolation. Newton steps move the vertices onto
// the exact zero set; where the gradients around a vertex disagree (a crease), the vertex moves to
// the point that fits all tangent planes (ju2002).
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>
#include <vug/mesh/mesh.h>
#include <vug/meshing/lattice_keys.h>
#include <vug/meshing/polish_cache.h>
#include <vug/volume/level_set.h>

#include <optional>

namespace vug::meshing {

struct PolygonizeOptions {
  double adaptivity = 0;  ///< 0..1: degree to which flat regions are merged into larger polygons.
  bool polish = true;     ///< Move vertices onto the exact field.
  bool creases = true;    ///< Keep edges and corners sharp.
  double crease_angle = 25;  ///< Angle in degrees between the gradients around a vertex above which
                             ///< it is on a crease.
  double max_move = 1;  ///< Maximum displacement of a vertex in voxels; creases add up to 0.25.
  bool normals = true;  ///< Exact gradients; on creases the mean normal of the adjacent triangles.
  bool keys = false;    ///< Return the places of vertices and triangles in the canonical order.
};

/// Quality of the polished mesh. Lengths are in voxels.
struct PolishReport {
  size_t crease_vertices = 0;
  size_t shortened_moves = 0;  ///< Moves shortened because they would fold a polygon.
  double rms_residual = 0;     ///< First-order distance of the vertices from the exact surface.
  double max_residual = 0;
  double max_move = 0;
};

struct PolygonizeResult {
  mesh::Mesh mesh;
  PolishReport report;
  std::optional<LatticeKeys> keys;
};

/// `exact` is the field that the level set samples, on the lattice through the origin. Without it
/// vertices stay where OpenVDB places them and normals come from the triangles. Fields are
/// evaluated in single precision if that locates the surface to 1e-3 voxel, otherwise in double
/// precision. The mesh is closed where the level set is, oriented outwards, and has the same bytes
/// for any number of threads. Its vertices are in the order of the lattice's cells, and triangles
/// in the order of their vertices, so that parts of a surface that are meshed separately agree. The
/// level set does not contain walls thinner than one or two voxels and the tips of edges sharper
/// than about 60 degrees. Throws Error(cancelled).
PolygonizeResult polygonize(const volume::LevelSet& level_set, const field::Field* exact,
                            const PolygonizeOptions& options = {},
                            Progress& progress = Progress::none());

/// The same bytes; parts whose polygons and field are as in an earlier call with this cache are not
/// polished again. See polish_cache.h.
PolygonizeResult polygonize(const volume::LevelSet& level_set, const field::Field* exact,
                            const PolygonizeOptions& options, PolishCache& cache,
                            Progress& progress = Progress::none());

}  // namespace vug::meshing
