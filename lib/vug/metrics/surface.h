// Area, volume and convexity of a triangle mesh.
#pragma once

#include <vug/mesh/topology.h>

#include <optional>

namespace vug::metrics {

/// Sum of the triangles' areas, square metres: eq. 9 with the norm it needs.
double area(const mesh::Mesh& mesh);

/// Cubic metres, by the divergence theorem; positive for closed meshes that face outwards.
double volume(const mesh::Mesh& mesh);

/// Edges between two triangles by the side they bend to, seen from outside. Flat edges are
/// those whose far corners lie in the neighbour's plane up to the rounding of positions.
struct Convexity {
  size_t convex = 0;
  size_t concave = 0;
  double convex_area = 0;  ///< Sums of the areas of both triangles at each edge.
  double concave_area = 0;

  /// Eq. 11: 100 * convex / bent edges; empty without any.
  std::optional<double> cf() const;
  std::optional<double> cf_area() const;
};
Convexity convexity(const mesh::Mesh& mesh, const mesh::Edges& edges);

}  // namespace vug::metrics
