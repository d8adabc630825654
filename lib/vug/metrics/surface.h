// SPDX-License-Identifier: Apache-2.0
// Area, volume and convexity of a triangle mesh.
#pragma once

#include <vug/mesh/topology.h>

#include <optional>

namespace vug::metrics {

/// Sum of the triangles' areas in square metres: eq. 9 with the norm that it omits.
double area(const mesh::Mesh& mesh);

/// Cubic metres, by the divergence theorem; positive for closed meshes that are oriented outwards.
double volume(const mesh::Mesh& mesh);

/// Edges between two triangles, classified as convex or concave seen from outside. An edge is flat
/// if the opposite corners lie in the neighbour's plane within the rounding of positions.
struct Convexity {
  size_t convex = 0;
  size_t concave = 0;
  double convex_area = 0;  ///< Sums of the areas of both triangles at each edge.
  double concave_area = 0;

  /// Eq. 11: 100 * convex / bent edges; empty if there are no bent edges.
  std::optional<double> cf() const;
  std::optional<double> cf_area() const;
};
Convexity convexity(const mesh::Mesh& mesh, const mesh::Edges& edges);

}  // namespace vug::metrics
