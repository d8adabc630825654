// SPDX-License-Identifier: Apache-2.0
// Builds the mesh of a plan from a level set or from a file: choice of the exact field for its
// vertices (with the faces of the region), polygonization, removal of small components, vertex
// colours.
#pragma once

#include <vug/base/progress.h>
#include <vug/building/part_cache.h>
#include <vug/mesh/components.h>
#include <vug/meshing/polygonize.h>
#include <vug/shot/shot.h>
#include <vug/volume/level_set.h>
#include <vug/volume/small_features.h>

namespace vug::building {

/// The part of a mesh that follows from its volume and from how it is polygonized; it can be
/// stored.
struct SurfaceMesh {
  mesh::LargeComponents pieces;  ///< Without attributes.
  /// Removed from the surface, or kept, as the plan says.
  std::vector<volume::SmallFeature> small_features = {};
  std::vector<mesh::Attribute> rock_weights = {};  ///< See add_rock_weights.
};

/// The level set of a plan and what is known about it.
struct SampledSurface {
  const volume::LevelSet& level_set;
  const std::vector<volume::SmallFeature>& small_features;
  /// The volume's field with the faces of its region; null: vertices stay where the samples place
  /// them.
  const field::Field* exact;
};

/// The triangles of the surface, with all components and without attributes but normals; small
/// features are removed if the plan says so. `keys`: see meshing::PolygonizeOptions. `parts` may be
/// null.
meshing::PolygonizeResult polygonize_plan(const shot::MeshPlan& plan, const SampledSurface& surface,
                                          bool keys, PartCache* parts, Progress& progress);

/// The mesh of the plan's level set without its small components. Error(too_large) if `memory`
/// bytes do not suffice. `parts` may be null.
SurfaceMesh make_surface_mesh(const shot::MeshPlan& plan, const volume::LevelSet& surface,
                              uint64_t memory, Progress& progress, PartCache* parts = nullptr);

/// Adds vertex colours, the attributes of facade elements, labels, and the weights of the rock.
/// `solid` is the level set if the plan has a paint, else it may be null.
void add_attributes(SurfaceMesh& mesh, const shot::MeshPlan& plan, const field::SampledGrid* solid);

/// The mesh of the plan's file without its small components, with vertex colours.
mesh::LargeComponents make_mesh(const shot::MeshPlan& plan);

/// The meshes combined in their order. Attributes that a mesh lacks are 0 there; normals are kept
/// only if all meshes have them.
mesh::Mesh merge_meshes(const std::vector<mesh::MeshPtr>& parts);

/// Evaluates the paint at the vertices and adds the colours as attribute Cd. The mesh must have
/// normals; `solid` is the level set of which it is the surface, or null.
void add_colors(mesh::Mesh& mesh, const paint::Paint& paint, const field::SampledGrid* solid);

/// The mesh with triangles no larger than the plan's cells. Error(too_large) at the location of
/// `spacing`.
mesh::MeshPtr refine_for_cells(const shot::CellsPlan& plan, const mesh::Mesh& mesh,
                               uint64_t memory);

}  // namespace vug::building
