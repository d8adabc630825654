// SPDX-License-Identifier: Apache-2.0
// Computes the products of a shot: grids, meshes, surfaces and cell layers, each once and on
// demand.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/progress.h>
#include <vug/building/apply_cells.h>
#include <vug/building/part_cache.h>
#include <vug/building/stored_products.h>
#include <vug/mesh/mesh.h>
#include <vug/shot/shot.h>
#include <vug/volume/level_set.h>
#include <vug/volume/small_features.h>
#include <vug/volume/surface_bricks.h>
#include <vug/volume/voxelize.h>

#include <functional>
#include <map>
#include <set>

namespace vug::building {

struct BuildOptions {
  uint64_t max_memory = 0;  ///< Memory limit of a Builder in bytes; 0: the machine's free memory.
                            ///< Error(too_large) before work that needs more.
  /// Called with each warning, such as an empty grid, as soon as it is found.
  std::function<void(const Diagnostics&)> on_warning = nullptr;
  /// The text that made a node of a field, for warnings; null: unknown.
  std::function<SourceLocation(const field::NodePtr&)> where_of = nullptr;
  /// Checkpoint of the runs of cells; null: none.
  std::shared_ptr<CellsCheckpoint> checkpoint = nullptr;
  /// Products that are in a store are not built again; see product_keys.h.
  StoreUse stored = {};
};

class DripsReports;

/// The numbers of products that a Builder made or read from a store, without those that it took
/// over.
struct ProductCounts {
  size_t level_sets = 0, meshes = 0, surfaces = 0, cell_layers = 0;

  size_t total() const { return level_sets + meshes + surfaces + cell_layers; }
};

/// Builds the products of a shot and caches them. The shot must outlive it. Not thread-safe; the
/// work itself is parallel.
class Builder {
 public:
  explicit Builder(const shot::Shot& shot, BuildOptions options = {},
                   Progress& progress = Progress::none());

  /// Takes over the products of another builder whose plans this shot contains as well: for another
  /// frame of the same shot all static products (see loading::StaticCache), and runs of cells to
  /// continue.
  void reuse_from(Builder&& other);

  /// Takes parts of level sets and meshes from the cache, and adds those that are computed. Null:
  /// all are computed.
  void use_parts(PartCachePtr parts) { parts_ = std::move(parts); }

  /// Computes the deferred fields, such as drips, of the shown objects of the shot or a part of it.
  void compute_deferred(const shot::Shot& part);
  const volume::LevelSet& level_set(const shot::VolumePtr& plan);
  mesh::MeshPtr mesh(const shot::MeshPtr& plan);
  /// Whether the mesh has been built.
  bool has_mesh(const shot::MeshPtr& plan) const { return cached(plan) != nullptr; }
  /// The level set of which the mesh is the surface, for masks; null if there is none. The same
  /// object at each call.
  std::shared_ptr<const field::SampledGrid> solid(const shot::MeshPtr& plan);
  /// The cell layer of a plan.
  CellLayerPtr cell_layer(const shot::CellsPtr& plan);
  /// The isosurface of the plan for direct ray tracing, without a mesh.
  volume::SurfaceBricksPtr surface(const shot::MeshPtr& plan);
  /// Number of components that `smallest_piece` removed from the mesh or surface; 0 before it is
  /// built.
  size_t components_removed(const shot::MeshPtr& plan) const;
  /// Bubbles and handles of the mesh that were smaller than two voxels; none before it is built.
  std::vector<volume::SmallFeature> small_features(const shot::MeshPtr& plan) const;

  /// Error(too_large) if the estimate for the mesh, its grid and its cells exceeds the memory
  /// budget.
  void require_mesh_memory(const shot::MeshPtr& plan);
  /// Error(too_large) if the estimate for the surface and its grid exceeds the memory budget.
  void require_surface_memory(const shot::MeshPtr& plan);

  const shot::Shot& shot() const { return shot_; }
  const BuildOptions& options() const { return options_; }
  Progress& progress() const { return progress_; }
  /// Passes a warning about the scene text at `where` to BuildOptions::on_warning.
  void warn(const SourceLocation& where, const std::string& message, const std::string& hint) const;
  /// Bytes that further work may use; at least 1.
  uint64_t memory_budget() const;
  const ProductCounts& counts() const { return counts_; }
  /// Wall-clock seconds spent on products so far.
  double seconds() const { return seconds_; }

 private:
  const shot::Shot& shot_;
  BuildOptions options_;
  Progress& progress_;
  StoredProducts products_;
  std::map<shot::VolumePtr, volume::LevelSet> level_sets_;
  std::map<shot::VolumePtr, std::shared_ptr<const field::SampledGrid>> solids_;  ///< Views of them.
  struct BuiltMesh {
    std::shared_ptr<const mesh::Mesh> mesh;
    size_t components_removed = 0;
    std::vector<volume::SmallFeature> small_features = {};
    bool unfolded = false;  ///< Displacements were changed because they would have folded it.
  };
  std::map<shot::MeshPtr, BuiltMesh> meshes_;
  /// The mesh of the plan or of an equal plan; null if it has not been built.
  const BuiltMesh* cached(const shot::MeshPtr& plan) const;
  std::shared_ptr<const field::SampledGrid> solid_of(const shot::VolumePtr& volume);
  volume::LevelSet make_level_set(const shot::VolumePlan& plan, const mesh::Mesh* mesh);
  /// Passes warnings about the volume's thin parts on, once.
  void warn_of_thin_parts(const shot::VolumePlan& plan);
  std::set<const shot::VolumePlan*> warned_of_;
  /// Whether the mesh of the plan's volume is in the store, so that it needs no field.
  bool is_stored(const shot::MeshPlan& plan) const;
  /// The mesh of the plan's volume, with its attributes.
  SurfaceMesh surface_mesh(const shot::MeshPlan& plan);
  /// The mesh from which a volume is made; if cells displace it, it may have folds.
  mesh::MeshPtr mesh_for_volume(const shot::MeshPtr& plan);
  BuiltMesh build_plain(const shot::MeshPlan& plan);
  BuiltMesh build_with_cells(const shot::MeshPlan& plan, Folds folds);
  /// The mesh that build_with_cells makes from the cells, which run for it. `seconds` increases by
  /// the time.
  MeshWithCells run_cells(const shot::MeshPlan& plan, const mesh::Mesh& bare, bool refine,
                          Folds folds, double& seconds);
  /// The key of such a mesh; nothing if it cannot be stored.
  std::optional<store::Key> cell_mesh_key(const shot::MeshPlan& plan, const mesh::Mesh& bare,
                                          bool refine, Folds folds);
  BuiltMesh build_merged(const shot::MeshPlan& plan);
  /// Locates an error at the volume's line if the scene text is at fault; else adds `doing` as
  /// context.
  static Error volume_error(const shot::VolumePlan& plan, Error& error, std::string doing);
  /// The memory of the plan's level set, estimated once.
  const volume::VoxelizeEstimate& estimate(const shot::VolumePtr& plan) const;
  mutable std::map<shot::VolumePtr, volume::VoxelizeEstimate> estimates_;
  /// Approximate surface area of the volume in square metres.
  double area_of(const shot::VolumePtr& plan);
  /// An upper bound of it that needs no samples of the field.
  double max_area_of(const shot::VolumePtr& plan);
  volume::SurfaceBricksPtr cached_surface(const shot::MeshPtr& plan) const;
  /// A run that a run of the plan can continue; null if there is none.
  CellLayerPtr resumable(const shot::CellsPlan& plan) const;
  std::map<shot::CellsPtr, CellLayerPtr> cell_layers_;
  std::map<shot::CellsPtr, CellLayerPtr> resumable_;  ///< Runs of an earlier frame to continue.
  std::map<shot::MeshPtr, volume::SurfaceBricksPtr> surfaces_;
  ProductCounts counts_;
  double seconds_ = 0;
  uint64_t held_ = 0;  ///< Bytes of all cached products.
  PartCachePtr parts_;
  std::shared_ptr<DripsReports> drips_reports_;
};

}  // namespace vug::building
