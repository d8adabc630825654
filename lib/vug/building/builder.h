// From a shot to its products: grids and meshes, each computed once when first asked for.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/progress.h>
#include <vug/building/cell_layer.h>
#include <vug/mesh/mesh.h>
#include <vug/shot/shot.h>
#include <vug/volume/level_set.h>
#include <vug/volume/surface_bricks.h>

#include <functional>
#include <map>

namespace vug::building {

struct BuildOptions {
  uint64_t max_memory = 0;  ///< Bytes for all that a Builder holds and does; 0: what the machine
                            ///< has free. Error(too_large) before work that needs more.
  /// Told of what is doubtful, such as an empty grid, as soon as it shows.
  std::function<void(const Diagnostics&)> on_warning = nullptr;
  /// Keeps the runs of cells; null: nothing does.
  std::shared_ptr<CellsCheckpoint> checkpoint = nullptr;
};

/// Holds products while they are needed. The shot must outlive it. Not for several threads at
/// once; the work inside is parallel.
class Builder {
 public:
  explicit Builder(const shot::Shot& shot, BuildOptions options = {},
                   Progress& progress = Progress::none())
      : shot_(shot), options_(options), progress_(progress) {}

  /// Keeps what another builder has made of plans that this one's shot has, too: of the same shot
  /// at another frame all that stands still (see Still), and runs of cells that only go on.
  void reuse_from(Builder&& other);

  const volume::LevelSet& level_set(const shot::VolumePtr& plan);
  mesh::MeshPtr mesh(const shot::MeshPtr& plan);
  /// The level set whose surface the mesh is, for masks; null where there is none.
  std::shared_ptr<const field::SampledGrid> solid(const shot::MeshPtr& plan);
  /// The cells that a mesh wears.
  CellLayerPtr cell_layer(const shot::CellsPtr& plan);
  /// The surface that the mesh would stand for, without one.
  volume::SurfaceBricksPtr surface(const shot::MeshPtr& plan);
  /// How many pieces `smallest_piece` has taken from the mesh or surface; 0 before it is made.
  size_t components_removed(const shot::MeshPtr& plan) const;

  /// Error(too_large) where the mesh, its grid and its cells are sure to need more than there is,
  /// as far as that shows before the work.
  void require_mesh_memory(const shot::MeshPtr& plan) const;
  /// The same for the surface and its grid.
  void require_surface_memory(const shot::MeshPtr& plan) const;

  const shot::Shot& shot() const { return shot_; }
  const BuildOptions& options() const { return options_; }
  Progress& progress() const { return progress_; }
  /// Tells of something doubtful that stands in the scene's text at `where`.
  void warn(const SourceLocation& where, const std::string& message, const std::string& hint) const;
  /// Bytes that further work may take, at least 1.
  uint64_t memory_budget() const;
  /// Wall-clock seconds spent on grids and meshes so far.
  double seconds() const { return seconds_; }

 private:
  const shot::Shot& shot_;
  BuildOptions options_;
  Progress& progress_;
  std::map<shot::VolumePtr, volume::LevelSet> level_sets_;
  struct BuiltMesh {
    std::shared_ptr<const mesh::Mesh> mesh;
    size_t components_removed = 0;
  };
  std::map<shot::MeshPtr, BuiltMesh> meshes_;
  /// What has been made of a plan, or of one just like it; null when nothing has.
  const BuiltMesh* cached(const shot::MeshPtr& plan) const;
  volume::LevelSet make_level_set(const shot::VolumePlan& plan);
  BuiltMesh build_plain(const shot::MeshPlan& plan);
  BuiltMesh build_with_cells(const shot::MeshPlan& plan);
  BuiltMesh build_merged(const shot::MeshPlan& plan);
  /// Square metres of the volume's surface, about.
  double area_of(const shot::VolumePtr& plan) const;
  volume::SurfaceBricksPtr cached_surface(const shot::MeshPtr& plan) const;
  /// A run that one of the plan would only go on from; null where there is none.
  CellLayerPtr resumable(const shot::CellsPlan& plan) const;
  std::map<shot::CellsPtr, CellLayerPtr> cell_layers_;
  std::map<shot::CellsPtr, CellLayerPtr>
      resumable_;  ///< Runs of an earlier frame that a plan's goes on from.
  std::map<shot::MeshPtr, volume::SurfaceBricksPtr> surfaces_;
  double seconds_ = 0;
  uint64_t held_ = 0;  ///< Bytes of grids, meshes, skins and surfaces.
};

}  // namespace vug::building
