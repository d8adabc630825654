// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/building/apply_cells.h>
#include <vug/building/builder.h>
#include <vug/building/cells_checkpoint.h>
#include <vug/building/make_mesh.h>
#include <vug/building/memory_estimate.h>
#include <vug/building/product_keys.h>
#include <vug/building/stopwatch.h>
#include <vug/building/stored_drips.h>
#include <vug/building/thin_part_warnings.h>
#include <vug/field/deferred.h>
#include <vug/shot/queries.h>
#include <vug/volume/from_mesh.h>
#include <vug/volume/level_set_field.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace vug::building {
namespace {

/// The probable reason why a volume is empty.
std::string why_empty(const shot::VolumePlan& plan) {
  const Box3d& bounds = plan.field.bounds();
  if (plan.source_mesh) return "its mesh is empty or thinner than a voxel";
  if (bounds.isEmpty()) return "its solid is empty";
  if (plan.from && !bounds.intersects(Box3d(*plan.from, *plan.to)))
    return "its solid lies outside of 'from' and 'to'";
  return "its solid is empty or thinner than a voxel";
}

/// Adds the plan and all meshes that it depends on.
void add_with_parts(const shot::MeshPtr& plan, std::vector<shot::MeshPtr>& meshes) {
  meshes.push_back(plan);
  for (const shot::MeshPtr& part : plan->parts) add_with_parts(part, meshes);
  if (plan->volume && plan->volume->source_mesh) add_with_parts(plan->volume->source_mesh, meshes);
  if (!plan->cells) return;
  for (const shot::MeshPtr& support : plan->cells->on) add_with_parts(support, meshes);
}

}  // namespace

Builder::Builder(const shot::Shot& shot, BuildOptions options, Progress& progress)
    : shot_(shot),
      options_(std::move(options)),
      progress_(progress),
      products_(options_.stored),
      drips_reports_(store_drips(shot, options_.stored)) {}

void Builder::warn(const SourceLocation& where, const std::string& message,
                   const std::string& hint) const {
  if (!options_.on_warning) return;
  Diagnostics one;
  one.warning(where, message, hint);
  options_.on_warning(one);
}

const Builder::BuiltMesh* Builder::cached(const shot::MeshPtr& plan) const {
  if (const auto found = meshes_.find(plan); found != meshes_.end()) return &found->second;
  for (const auto& [other, mesh] : meshes_)
    if (*other == *plan) return &mesh;
  return nullptr;
}

volume::SurfaceBricksPtr Builder::cached_surface(const shot::MeshPtr& plan) const {
  for (const auto& [other, surface] : surfaces_)
    if (other->volume == plan->volume && other->smallest_piece == plan->smallest_piece)
      return surface;
  return nullptr;
}

void Builder::reuse_from(Builder&& other) {
  std::set<shot::VolumePtr> volumes(shot_.volumes.begin(), shot_.volumes.end());
  for (const shot::MediumPlan& air : shot_.media) volumes.insert(air.volume);
  std::vector<shot::MeshPtr> meshes;
  for (const shot::VolumePtr& volume : shot_.volumes)
    if (volume->source_mesh) add_with_parts(volume->source_mesh, meshes);
  for (const shot::MeshPtr& plan : shot::shown_meshes(shot_)) add_with_parts(plan, meshes);
  for (const shot::ObjectPlan& object : shot_.objects) add_with_parts(object.mesh, meshes);
  for (const shot::PointInstancer& place : shot_.instancers)
    for (const shot::Model& model : place.of)
      if (model.mesh) add_with_parts(model.mesh, meshes);
  for (const shot::MeshPtr& plan : meshes) {
    if (plan->volume) volumes.insert(plan->volume);
    const BuiltMesh* mesh = other.cached(plan);
    if (mesh && meshes_.emplace(plan, *mesh).second) held_ += bytes_of(*mesh->mesh);
    if (const auto layer = other.cell_layers_.find(plan->cells);
        layer != other.cell_layers_.end() && cell_layers_.insert(*layer).second)
      held_ += layer->second->simulation.bytes();
    if (!plan->cells || cell_layers_.count(plan->cells)) continue;
    if (const CellLayerPtr resumable = other.resumable(*plan->cells))
      if (resumable_.emplace(plan->cells, resumable).second) held_ += resumable->simulation.bytes();
  }
  for (const shot::MeshPtr& plan : meshes)
    if (const auto known = other.cached_surface(plan);
        known && surfaces_.emplace(plan, known).second)
      held_ += known->bytes();
  for (auto& [plan, grid] : other.level_sets_)
    if (volumes.count(plan)) {
      held_ += grid.statistics().memory_bytes;
      level_sets_.emplace(plan, std::move(grid));
      if (const auto solid = other.solids_.find(plan); solid != other.solids_.end())
        solids_.insert(*solid);
    }
  seconds_ += other.seconds_;
  other.level_sets_.clear(), other.solids_.clear(), other.meshes_.clear(),
      other.cell_layers_.clear(), other.surfaces_.clear();
}

void Builder::warn_of_thin_parts(const shot::VolumePlan& plan) {
  if (!options_.on_warning || plan.source_mesh || !warned_of_.insert(&plan).second) return;
  if (const Diagnostics thin = thin_part_warnings(plan, options_.where_of); !thin.all().empty())
    options_.on_warning(thin);
}

volume::LevelSet Builder::make_level_set(const shot::VolumePlan& plan, const mesh::Mesh* mesh) {
  const CancellableScope scope(progress_);
  const Progress::Product product(progress_, plan.name);
  if (!mesh) {
    field::compute_deferred(plan.field, progress_, memory_budget());
    warn_of_thin_parts(plan);  // Before the voxels, whose number may make them slow.
    const volume::VoxelizeOptions options = voxelize_options(plan, memory_budget());
    if (parts_) return volume::voxelize(plan.field, options, parts_->voxels, progress_);
    return volume::voxelize(plan.field, options, progress_);
  }
  volume::FromMeshOptions options;
  options.voxel = plan.voxel;
  options.half_width = plan.half_width;
  options.max_memory = memory_budget();
  return volume::from_mesh(*mesh, options, progress_);
}

const volume::LevelSet& Builder::level_set(const shot::VolumePtr& plan) {
  if (const auto found = level_sets_.find(plan); found != level_sets_.end()) return found->second;
  try {
    const mesh::MeshPtr mesh = plan->source_mesh ? mesh_for_volume(plan->source_mesh) : nullptr;
    const auto obtained = products_.obtain<volume::LevelSet>(
        level_set_key(*plan, mesh.get()), plan->name,
        [&](double& seconds) {
          const Stopwatch watch(seconds);
          return make_level_set(*plan, mesh.get());
        },
        seconds_);
    const volume::LevelSet& made = level_sets_.emplace(plan, obtained).first->second;
    ++counts_.level_sets;
    held_ += made.statistics().memory_bytes;
    warn_of_thin_parts(*plan);
    if (!made.holds_solid())
      warn(plan->where, fmt::format("the volume '{}' is empty", plan->name), why_empty(*plan));
    return made;
  } catch (Error& error) {
    throw volume_error(*plan, error, fmt::format("making the volume '{}'", plan->name));
  }
}

mesh::MeshPtr Builder::mesh(const shot::MeshPtr& plan) {
  if (const BuiltMesh* known = cached(plan)) return known->mesh;
  require_mesh_memory(plan);
  try {
    BuiltMesh mesh = plan->cells            ? build_with_cells(*plan, Folds::prevent)
                     : !plan->parts.empty() ? build_merged(*plan)
                                            : build_plain(*plan);
    held_ += bytes_of(*mesh.mesh);
    ++counts_.meshes;
    return meshes_.emplace(plan, std::move(mesh)).first->second.mesh;
  } catch (Error& error) {
    throw error.within(fmt::format("making the mesh '{}'", plan->name));
  }
}

mesh::MeshPtr Builder::mesh_for_volume(const shot::MeshPtr& plan) {
  if (const BuiltMesh* known = cached(plan); known && !known->unfolded) return known->mesh;
  if (!plan->cells || !plan->cells->move) return mesh(plan);
  require_mesh_memory(plan);
  try {
    return build_with_cells(*plan, Folds::allow).mesh;
  } catch (Error& error) {
    throw error.within(fmt::format("making the mesh '{}'", plan->name));
  }
}

Builder::BuiltMesh Builder::build_plain(const shot::MeshPlan& plan) {
  SurfaceMesh made = plan.file_mesh ? SurfaceMesh{make_mesh(plan)} : surface_mesh(plan);
  if (plan.topology == shot::SmallTopology::keep && !made.small_features.empty())
    warn(plan.volume->where,
         fmt::format("the mesh '{}' has features smaller than two voxels: {}", plan.name,
                     describe(made.small_features)),
         "topology clean removes them");
  return {std::make_shared<const mesh::Mesh>(std::move(made.pieces.mesh)), made.pieces.removed,
          std::move(made.small_features), false};
}

bool Builder::is_stored(const shot::MeshPlan& plan) const {
  return plan.volume && !plan.cells && !plan.volume->source_mesh &&
         products_.contains(surface_mesh_key(plan, shot_.draft));
}

SurfaceMesh Builder::surface_mesh(const shot::MeshPlan& plan) {
  const store::Key key = plan.volume->source_mesh
                             ? surface_mesh_key(plan, shot_.draft, level_set(plan.volume))
                             : surface_mesh_key(plan, shot_.draft);
  SurfaceMesh made = products_.obtain<SurfaceMesh>(
      key, plan.name,
      [&](double& seconds) {
        const volume::LevelSet& surface = level_set(plan.volume);
        const Stopwatch watch(seconds);
        const Progress::Product product(progress_, plan.name);
        // Their materials count, too.
        field::compute_deferred(plan.volume->field, progress_, memory_budget());
        shot::MeshPlan quality = plan;
        quality.polish = plan.polish && !shot_.draft;
        return make_surface_mesh(quality, surface, memory_budget(), progress_, parts_.get());
      },
      seconds_);
  warn_of_thin_parts(*plan.volume);
  const auto solid = plan.paint ? solid_of(plan.volume) : nullptr;
  const Stopwatch watch(seconds_);
  add_attributes(made, plan, solid.get());
  return made;
}

Builder::BuiltMesh Builder::build_with_cells(const shot::MeshPlan& plan, Folds folds) {
  const bool refine = plan.cells->refine.value_or(!plan.volume);
  if (plan.volume && !refine && plan.volume->voxel > 1.01 * plan.cells->spacing)
    warn(plan.cells->where,
         fmt::format("the voxels of '{}' are larger than the cells, so some cells will not "
                     "be visible",
                     plan.volume->name),
         "use smaller voxels, a larger spacing or refine true");
  const shot::MeshPtr under = shot::mesh_without_cells(plan);
  const mesh::MeshPtr bare = mesh(under);
  const auto make = [&](double& seconds) { return run_cells(plan, *bare, refine, folds, seconds); };
  MeshWithCells made;
  if (const std::optional<store::Key> key = cell_mesh_key(plan, *bare, refine, folds)) {
    made = products_.obtain<MeshWithCells>(*key, plan.name, make, seconds_);
  } else {
    double seconds = 0;
    made = make(seconds);
    seconds_ += seconds;
  }
  const auto worn = std::make_shared<const mesh::Mesh>(std::move(made.mesh));
  if (worn->triangles.empty() && !bare->triangles.empty())
    warn(plan.cells->where, fmt::format("nothing remains of the mesh '{}'", plan.name),
         "all of its cells have been removed, and 'holes' cuts the mesh there");
  return {worn, components_removed(under), small_features(under), made.unfolded_vertices > 0};
}

MeshWithCells Builder::run_cells(const shot::MeshPlan& plan, const mesh::Mesh& bare, bool refine,
                                 Folds folds, double& seconds) {
  const double before = seconds_;
  const CellLayerPtr layer = this->cell_layer(plan.cells);
  seconds += std::exchange(seconds_, before) - before;
  const Stopwatch watch(seconds);
  const Progress::Product product(progress_, plan.name);
  if (!refine) return apply_cells(bare, *layer, *plan.cells, folds, progress_);
  const mesh::MeshPtr refined = run_stage(progress_, "refining the mesh", [&] {
    return refine_for_cells(*plan.cells, bare, memory_budget());
  });
  return apply_cells(*refined, *layer, *plan.cells, folds, progress_);
}

std::optional<store::Key> Builder::cell_mesh_key(const shot::MeshPlan& plan, const mesh::Mesh& bare,
                                                 bool refine, Folds folds) {
  const shot::CellsPlan& cells = *plan.cells;
  if (!options_.stored.store || options_.checkpoint || !cells.inputs || cells.before)
    return std::nullopt;
  store::Key key(kCellMeshKind);
  key.add("cells", *cells.inputs, cells.key.state())
      .add("use", cells.first_step, cells.length(), plan.support, refine, folds)
      .add("mesh", mesh::digest(bare));
  for (size_t i = 0; i < cells.on.size(); ++i) {
    key.add(fmt::format("support_{}", i), mesh::digest(*mesh(cells.on[i])));
    const shot::VolumePtr& volume = cells.on[i]->volume;
    if (!volume) continue;
    key.add(fmt::format("solid_{}", i),
            volume->source_mesh ? level_set(volume).content() : level_set_key(*volume).digest());
  }
  return key;
}

Builder::BuiltMesh Builder::build_merged(const shot::MeshPlan& plan) {
  std::vector<mesh::MeshPtr> parts;
  BuiltMesh made;
  for (const shot::MeshPtr& part : plan.parts) {
    parts.push_back(mesh(part));
    made.components_removed += components_removed(part);
    for (const volume::SmallFeature& each : small_features(part))
      made.small_features.push_back(each);
  }
  made.mesh = std::make_shared<const mesh::Mesh>(merge_meshes(parts));
  return made;
}

std::shared_ptr<const field::SampledGrid> Builder::solid(const shot::MeshPtr& plan) {
  return plan->volume ? solid_of(plan->volume) : nullptr;
}

std::shared_ptr<const field::SampledGrid> Builder::solid_of(const shot::VolumePtr& volume) {
  const volume::LevelSet& grid = level_set(volume);
  auto& solid = solids_[volume];
  if (!solid) solid = volume::sampled_grid(grid);
  return solid;
}

CellLayerPtr Builder::resumable(const shot::CellsPlan& plan) const {
  const auto same = [](const shot::MeshPtr& a, const shot::MeshPtr& b) { return *a == *b; };
  for (const auto* runs : {&cell_layers_, &resumable_})
    for (const auto& [other, layer] : *runs)
      if (plan.resumable && other->resumable && other->name == plan.name &&
          layer->simulation.step() <= plan.length() &&
          std::equal(other->on.begin(), other->on.end(), plan.on.begin(), plan.on.end(), same))
        return layer;
  return nullptr;
}

CellLayerPtr Builder::cell_layer(const shot::CellsPtr& plan) {
  if (const auto known = cell_layers_.find(plan); known != cell_layers_.end()) return known->second;
  std::vector<CellSupport> supports;
  for (const shot::MeshPtr& each : plan->on) supports.push_back({mesh(each), solid(each)});
  const CellLayerPtr before = plan->before ? cell_layer(plan->before) : nullptr;
  const Stopwatch watch(seconds_);
  const Progress::Product product(progress_, plan->name);
  try {
    CellRunOptions how{nullptr, options_.checkpoint.get(), before};
    if (const auto resumable = resumable_.find(plan); resumable != resumable_.end())
      how.from = resumable->second;
    auto made = std::make_shared<const CellLayer>(
        make_cell_layer(*plan, supports, memory_budget(), progress_, how));
    if (how.from) held_ -= how.from->simulation.bytes(), resumable_.erase(plan);
    held_ += made->simulation.bytes();
    ++counts_.cell_layers;
    return cell_layers_.emplace(plan, std::move(made)).first->second;
  } catch (Error& error) {
    throw error.within(fmt::format("making the cells '{}'", plan->name));
  }
}

volume::SurfaceBricksPtr Builder::surface(const shot::MeshPtr& plan) {
  if (const auto known = cached_surface(plan)) return known;
  require_surface_memory(plan);
  const volume::LevelSet& grid = level_set(plan->volume);
  const Stopwatch watch(seconds_);
  const auto active = static_cast<double>(grid.statistics().active_voxels);
  const double area = area_of_band(active, *plan->volume);
  try {
    require_memory(surface_bytes(area, plan->volume->voxel), memory_budget(), "the surface");
    const Progress::Product product(progress_, plan->name);
    auto made = run_stage(progress_, "surface", [&] {
      return std::make_shared<const volume::SurfaceBricks>(grid, plan->smallest_piece);
    });
    held_ += made->bytes();
    ++counts_.surfaces;
    return surfaces_.emplace(plan, std::move(made)).first->second;
  } catch (Error& error) {
    throw error.within(fmt::format("making the surface of '{}'", plan->name));
  }
}

size_t Builder::components_removed(const shot::MeshPtr& plan) const {
  if (const BuiltMesh* known = cached(plan)) return known->components_removed;
  const auto surface = cached_surface(plan);
  return surface ? surface->components_removed() : 0;
}

std::vector<volume::SmallFeature> Builder::small_features(const shot::MeshPtr& plan) const {
  const BuiltMesh* known = cached(plan);
  return known ? known->small_features : std::vector<volume::SmallFeature>();
}

}  // namespace vug::building
