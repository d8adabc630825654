// SPDX-License-Identifier: Apache-2.0
// Connectivity of a triangle mesh: edges with their faces, components, boundaries and genus.
#pragma once

#include <vug/mesh/mesh.h>

#include <optional>

namespace vug::mesh {

/// Half-edge h = 3 * face + k runs from corner k of the face to the next corner.
inline constexpr uint32_t next_half_edge(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

/// An undirected edge with low < high; its half-edges are half_edges[begin .. begin + count) of
/// Edges.
struct Edge {
  uint32_t low = 0;
  uint32_t high = 0;
  uint32_t begin = 0;
  uint32_t count =
      0;  ///< 1 on a boundary, 2 inside a manifold surface, more at non-manifold edges.
};

/// All edges, ordered by (low, high), and the half-edges of each edge in ascending order. A
/// triangle that uses a vertex twice has no edge from that vertex to itself.
struct Edges {
  std::vector<Edge> edges;
  std::vector<uint32_t> half_edges;
};

Edges find_edges(const Mesh& mesh);

/// The component of each triangle (connected by edges), numbered from 0 in order of its first
/// triangle.
std::vector<uint32_t> face_components(const Mesh& mesh, const Edges& edges);

/// Counts that describe the quality of a mesh.
struct Topology {
  size_t edges = 0;
  size_t boundary_edges = 0;        ///< Edges with one triangle.
  size_t nonmanifold_edges = 0;     ///< Edges with more than two triangles.
  size_t misoriented_edges = 0;     ///< Edges whose two triangles disagree about the outside.
  size_t nonmanifold_vertices = 0;  ///< Vertices at which several fans of triangles touch.
  size_t degenerate_triangles = 0;  ///< Triangles without area, within double precision.
  size_t unused_vertices = 0;
  size_t components = 0;      ///< Components connected by edges.
  size_t boundary_loops = 0;  ///< Boundary loops (holes).
  /// Total number of handles; only for surfaces without non-manifold or misoriented edges. Vertices
  /// at which fans touch are split first.
  std::optional<size_t> genus;

  bool closed() const { return boundary_edges == 0 && nonmanifold_edges == 0; }
};

Topology inspect(const Mesh& mesh);
Topology inspect(const Mesh& mesh, const Edges& edges);

}  // namespace vug::mesh
