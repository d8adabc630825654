// SPDX-License-Identifier: Apache-2.0
// Micro-displacement: divides the triangles of a mesh down to a given edge length, and moves each
// new vertex onto a field with more detail than the mesh (dicing, cook1987reyes).
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>
#include <vug/mesh/mesh.h>

#include <functional>

namespace vug::meshing {

/// The longest permitted edge near a point, in metres; positive. Called from several threads.
using EdgeLength = std::function<double(const Vec3d&)>;

struct DiceOptions {
  EdgeLength edge_length;
  int levels = 8;    ///< Each level halves the edges that are too long.
  double reach = 0;  ///< Distance in metres by which the mesh's own vertices may move.
};

struct DiceReport {
  size_t added_vertices = 0;
  /// New vertices without a zero of the field within the length of their edge along the normal,
  /// which stay in the middle of the edge, and vertices of the mesh without one within reach.
  size_t unfollowed = 0;
};

struct DiceResult {
  mesh::Mesh mesh;
  DiceReport report;
};

/// Divides edges longer than the edge length at either of their ends. Whether an edge is divided,
/// and the position of the new vertex, depend only on the edge's own two ends: triangles that share
/// an edge stay connected, so the result is as closed as the mesh, and a part of a mesh gives the
/// same triangles as the whole. The vertices of the mesh move onto the field first, too, each along
/// its normal. Normals are the gradients of the field, or
/// the mean normals of the triangles where these differ by more than 25 degrees, at creases and for
/// detail smaller than the triangles. Attributes are interpolated. Existing vertices keep their
/// numbers. The same bytes for any number of threads. Error(too_large) beyond 2^31 triangles;
/// Error(cancelled).
DiceResult dice(const mesh::Mesh& mesh, const field::Field& field, const DiceOptions& options,
                Progress& progress = Progress::none());

/// The approximate number of triangles that `dice` makes, within 5 % for meshes of more than some
/// thousand triangles: the number without displacement, corrected by the ratio for a sample of the
/// triangles, which are diced.
double estimate_diced_triangles(const mesh::Mesh& mesh, const field::Field& field,
                                const DiceOptions& options);

}  // namespace vug::meshing
