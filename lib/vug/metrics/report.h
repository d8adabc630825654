// SPDX-License-Identifier: Apache-2.0
// The report of `vug measure` on a solid, as a table and as JSON.
#pragma once

#include <vug/metrics/invalid_places.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::metrics {

/// A bubble or handle of the level set that is smaller than two voxels.
struct SmallFeaturePlace {
  std::string kind;  ///< "bubble", "crumb" or "handle".
  Vec3d centre;
  bool removed = false;  ///< From the mesh.
};

/// Values that cannot be derived from the input are empty (JSON: null).
struct Report {
  double area = 0;                     ///< Square metres (eq. 9).
  double volume = 0;                   ///< Cubic metres, by the divergence theorem.
  std::optional<double> volume_cells;  ///< Cubic metres, by counting cells (eq. 10).
  std::optional<double> cf;            ///< Percentage of bent edges that are convex (eq. 11).
  std::optional<double> cf_area;       ///< As `cf`, weighted by the area adjacent to each edge.
  size_t vertices = 0;
  size_t triangles = 0;
  std::optional<size_t> productions;
  std::optional<double> build_seconds;
  size_t components = 0;
  std::optional<size_t> genus;  ///< Handles of all components; empty if the mesh is not a surface.
  size_t boundary_edges = 0;
  size_t nonmanifold_edges = 0;
  size_t misoriented_edges = 0;
  size_t zero_area_triangles = 0;
  size_t folded_triangles = 0;  ///< Triangles that face against the surface around them.
  std::optional<size_t> self_intersections;  ///< Pairs of triangles; empty if not computed.
  size_t invalid_triangles = 0;  ///< Triangles that intersect others, are folded, or have no area.
  std::vector<InvalidPlace> invalid_places = {};
  std::vector<SmallFeaturePlace> small_features = {};
  Box3d bounds;

  /// The share of invalid triangles.
  double invalid_share() const {
    return triangles == 0 ? 0
                          : static_cast<double>(invalid_triangles) / static_cast<double>(triangles);
  }

  /// Whether the mesh bounds a solid: closed, two triangles at each edge, consistently oriented.
  bool is_closed_solid() const {
    return boundary_edges == 0 && nonmanifold_edges == 0 && misoriented_edges == 0;
  }
};

struct MeasureOptions {
  bool self_intersections = true;  ///< Takes longer than all other measures together.
  /// Whether components may penetrate each other, as stems do where they branch: then pairs of
  /// triangles of different components do not count as self-intersections.
  bool overlapping_components = false;
};

/// All values that the mesh alone provides. Bit-identical for any number of threads.
Report measure(const mesh::Mesh& mesh, const MeasureOptions& options = {});

/// One "name value unit" line each, aligned, with a final newline.
std::string to_table(const Report& report);
/// One object with keys in the order above; bounds as [[min], [max]], or null if empty.
std::string to_json(const Report& report);

}  // namespace vug::metrics
