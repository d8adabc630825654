// How the triangles of a mesh hang together: edges with their faces, pieces, holes, handles.
#pragma once

#include <vug/mesh/mesh.h>

#include <optional>

namespace vug::mesh {

/// Half-edge h = 3 * face + k runs from corner k of the face to its next corner.
inline constexpr uint32_t next_half_edge(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

/// An undirected edge, low < high; its half-edges are half_edges[begin .. begin + count) of Edges.
struct Edge {
  uint32_t low = 0;
  uint32_t high = 0;
  uint32_t begin = 0;
  uint32_t count = 0;  ///< 1 on a boundary, 2 inside a surface, more where it is not manifold.
};

/// All edges, ordered by (low, high); the half-edges of one edge by their number. Triangles that
/// use a vertex twice lose the edge that would run from it to itself.
struct Edges {
  std::vector<Edge> edges;
  std::vector<uint32_t> half_edges;
};

Edges find_edges(const Mesh& mesh);

/// The piece each triangle belongs to (joined along edges), numbered from 0 by first triangle.
std::vector<uint32_t> face_components(const Mesh& mesh, const Edges& edges);

/// What a mesher owes its user.
struct Topology {
  size_t edges = 0;
  size_t boundary_edges = 0;        ///< With one triangle.
  size_t nonmanifold_edges = 0;     ///< With more than two.
  size_t misoriented_edges = 0;     ///< Whose two triangles disagree about the outside.
  size_t nonmanifold_vertices = 0;  ///< Where several fans of triangles touch in a point.
  size_t degenerate_triangles = 0;  ///< Without area, as far as double precision tells.
  size_t unused_vertices = 0;
  size_t components = 0;      ///< Pieces joined along edges.
  size_t boundary_loops = 0;  ///< Holes.
  /// Handles of all pieces together; only for surfaces (no non-manifold or misoriented edge).
  /// Points where fans touch are taken apart first.
  std::optional<size_t> genus;

  bool closed() const { return boundary_edges == 0 && nonmanifold_edges == 0; }
};

Topology inspect(const Mesh& mesh);
Topology inspect(const Mesh& mesh, const Edges& edges);

}  // namespace vug::mesh
