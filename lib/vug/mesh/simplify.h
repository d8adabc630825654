// SPDX-License-Identifier: Apache-2.0
// Simplification of a mesh with locked borders: edge collapses by quadric error metrics that
// preserve the topology, so that pieces of a surface can be simplified one at a time.
#pragma once

#include <vug/mesh/mesh.h>

#include <memory>

namespace vug::mesh {

/// Collapses the edges of a mesh, the least visible ones first (Garland and Heckbert 1997, "Surface
/// simplification using quadric error metrics", cite garland1997), each to one of its vertices,
/// which keeps its position, normal and attributes.
///
/// Vertices on a border, and those at which the mesh is not a manifold, are never removed. Each
/// collapse satisfies the link condition (Dey et al. 1999, "Topology preserving edge contraction",
/// cite dey1999), and none creates an edge between two vertices of the border. Therefore the result
/// has the borders, bit for bit, the components and the genus of the mesh. If pieces of a closed
/// manifold are simplified separately, each to any number of triangles, then they form a closed
/// manifold again: an edge that is not on a border has a vertex inside of its piece, or existed
/// before. Triangles may intersect afterwards, as with other methods that only move along edges.
///
/// The order of collapses depends only on the mesh.
class Simplifier {
 public:
  /// The mesh must exist as long as this object.
  explicit Simplifier(const Mesh& mesh);
  ~Simplifier();
  Simplifier(const Simplifier&) = delete;
  Simplifier& operator=(const Simplifier&) = delete;

  /// Collapses edges until the number of triangles is at most `wanted`, or until no edge is left
  /// that may be collapsed. Calls with smaller and smaller numbers give the same meshes as single
  /// calls.
  void reduce_to(size_t wanted);
  /// The number of triangles now.
  size_t triangles() const;
  /// The number of edges of the mesh that have one triangle.
  size_t border_edges() const;
  /// The mesh as it is now, without unused vertices; vertices and triangles keep their order.
  Mesh mesh() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vug::mesh
