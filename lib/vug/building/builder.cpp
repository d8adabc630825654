#include <vug/base/memory.h>
#include <vug/building/apply_cells.h>
#include <vug/building/builder.h>
#include <vug/building/cells_checkpoint.h>
#include <vug/building/make_mesh.h>
#include <vug/building/memory_estimate.h>
#include <vug/metrics/surface.h>
#include <vug/shot/queries.h>
#include <vug/volume/from_mesh.h>
#include <vug/volume/level_set_field.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <set>

namespace vug::building {
namespace {

class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total) {}
  ~Stopwatch() { total_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& total_;
  Clock::time_point start_ = Clock::now();
};

/// Why nothing of a volume is there, as far as its plan tells.
std::string why_empty(const shot::VolumePlan& plan) {
  const Box3d& bounds = plan.field.bounds();
  if (plan.of) return "its mesh is empty or thinner than a voxel";
  if (bounds.isEmpty()) return "its solid is empty";
  if (plan.from && !bounds.intersects(Box3d(*plan.from, *plan.to)))
    return "its solid lies outside of 'from' and 'to'";
  return "its solid is empty or thinner than a voxel";
}

/// What a volume fails by: its line where the text is at fault, else while `doing` what.
Error of_volume(const shot::VolumePlan& plan, Error& error, std::string doing) {
  if (error.code() == ErrorCode::bad_input && !error.where().known()) return error.at(plan.where);
  return error.within(std::move(doing));
}

/// The plan and all that it is made of.
void add_with_parts(const shot::MeshPtr& plan, std::vector<shot::MeshPtr>& meshes) {
  meshes.push_back(plan);
  for (const shot::MeshPtr& part : plan->parts) add_with_parts(part, meshes);
  if (plan->volume && plan->volume->of) add_with_parts(plan->volume->of, meshes);
  if (!plan->cells) return;
  for (const shot::MeshPtr& ground : plan->cells->on) add_with_parts(ground, meshes);
}

}  // namespace

void Builder::warn(const SourceLocation& where, const std::string& message,
                   const std::string& hint) const {
  if (!options_.tell) return;
  Diagnostics one;
  one.warning(where, message, hint);
  options_.tell(one);
}

uint64_t Builder::room() const {
  if (options_.max_memory == 0) return available_memory();
  return options_.max_memory > held_ ? options_.max_memory - held_ : 1;
}

double Builder::area_of(const shot::VolumePtr& plan) const {
  if (const auto held = level_sets_.find(plan); held != level_sets_.end())
    return area_of_band(static_cast<double>(held->second.statistics().active_voxels), *plan);
  if (plan->of && plan->of->volume) return area_of(plan->of->volume);
  if (plan->field.bounds().isEmpty()) return 0;
  return volume::estimate(plan->field, voxelize_options(*plan, room())).surface_area;
}

const Builder::MadeMesh* Builder::made(const shot::MeshPtr& plan) const {
  if (const auto found = meshes_.find(plan); found != meshes_.end()) return &found->second;
  for (const auto& [other, mesh] : meshes_)
    if (*other == *plan) return &mesh;
  return nullptr;
}

volume::SurfaceBricksPtr Builder::made_surface(const shot::MeshPtr& plan) const {
  for (const auto& [other, surface] : surfaces_)
    if (other->volume == plan->volume && other->smallest_piece == plan->smallest_piece)
      return surface;
  return nullptr;
}

void Builder::take_over(Builder&& other) {
  std::set<shot::VolumePtr> volumes(shot_.volumes.begin(), shot_.volumes.end());
  volumes.insert(shot_.medium_volume);
  std::vector<shot::MeshPtr> meshes;
  for (const shot::VolumePtr& volume : shot_.volumes)
    if (volume->of) add_with_parts(volume->of, meshes);
  for (const shot::MeshPtr& plan : shot::meshes_of(shot_)) add_with_parts(plan, meshes);
  for (const shot::ObjectPlan& object : shot_.objects) add_with_parts(object.mesh, meshes);
  for (const shot::PlacePlan& place : shot_.places)
    for (const shot::Model& model : place.of)
      if (model.mesh) add_with_parts(model.mesh, meshes);
  for (const shot::MeshPtr& plan : meshes) {
    if (plan->volume) volumes.insert(plan->volume);
    const MadeMesh* mesh = other.made(plan);
    if (mesh && meshes_.emplace(plan, *mesh).second) held_ += bytes_of(*mesh->mesh);
    if (const auto skin = other.skins_.find(plan->cells);
        skin != other.skins_.end() && skins_.insert(*skin).second)
      held_ += skin->second->simulation.bytes();
    if (!plan->cells || skins_.count(plan->cells)) continue;
    if (const SkinPtr begun = other.begun(*plan->cells))
      if (begun_.emplace(plan->cells, begun).second) held_ += begun->simulation.bytes();
  }
  for (const shot::MeshPtr& plan : meshes)
    if (const auto known = other.made_surface(plan); known && surfaces_.emplace(plan, known).second)
      held_ += known->bytes();
  for (auto& [plan, grid] : other.level_sets_)
    if (volumes.count(plan)) {
      held_ += grid.statistics().memory_bytes;
      level_sets_.emplace(plan, std::move(grid));
    }
  seconds_ += other.seconds_;
  other.level_sets_.clear(), other.meshes_.clear(), other.skins_.clear(), other.surfaces_.clear();
}

volume::LevelSet Builder::make_level_set(const shot::VolumePlan& plan) {
  const mesh::MeshPtr mesh = plan.of ? this->mesh(plan.of) : nullptr;
  const Stopwatch watch(seconds_);
  if (!mesh) return volume::voxelize(plan.field, voxelize_options(plan, room()), progress_);
  volume::FromMeshOptions options;
  options.voxel = plan.voxel;
  options.half_width = plan.half_width;
  options.max_memory = room();
  return volume::from_mesh(*mesh, options, progress_);
}

const volume::LevelSet& Builder::level_set(const shot::VolumePtr& plan) {
  if (const auto found = level_sets_.find(plan); found != level_sets_.end()) return found->second;
  try {
    const volume::LevelSet& made = level_sets_.emplace(plan, make_level_set(*plan)).first->second;
    held_ += made.statistics().memory_bytes;
    if (!made.holds_solid())
      warn(plan->where, fmt::format("the volume '{}' comes out empty", plan->name),
           why_empty(*plan));
    return made;
  } catch (Error& error) {
    throw of_volume(*plan, error, fmt::format("making the volume '{}'", plan->name));
  }
}

void Builder::require_room(const shot::MeshPtr& plan) const {
  if (made(plan)) return;
  for (const shot::MeshPtr& part : plan->parts) require_room(part);
  if (plan->cells && skins_.count(plan->cells) == 0) {
    double area = 0;
    for (const shot::MeshPtr& ground : plan->cells->on) {
      require_room(ground);
      if (ground->volume) area += area_of(ground->volume);
      if (ground->given) area += metrics::area(*ground->given);
    }
    require_skin_room(*plan->cells, area, room());
  }
  if (plan->cells || !plan->volume) return;
  const shot::VolumePlan& volume = *plan->volume;
  if (volume.of) return require_room(volume.of);
  if (level_sets_.count(plan->volume) || volume.field.bounds().isEmpty()) return;
  const double band = 2 * volume.half_width;
  if (meshing_bytes(most_active_voxels(volume), band) <= static_cast<double>(room())) return;
  try {
    const auto estimate = volume::estimate(volume.field, voxelize_options(volume, room()));
    require_memory(estimate.bytes + meshing_bytes(estimate.active_voxels, band), room(),
                   fmt::format("a mesh and its grid with voxels of {} m", volume.voxel));
  } catch (Error& error) {
    throw of_volume(volume, error, fmt::format("making the mesh '{}'", plan->name));
  }
}

mesh::MeshPtr Builder::mesh(const shot::MeshPtr& plan) {
  if (const MadeMesh* known = made(plan)) return known->mesh;
  require_room(plan);
  try {
    MadeMesh mesh = plan->cells            ? make_worn(*plan)
                    : !plan->parts.empty() ? make_merged(*plan)
                                           : make_bare(*plan);
    held_ += bytes_of(*mesh.mesh);
    return meshes_.emplace(plan, std::move(mesh)).first->second.mesh;
  } catch (Error& error) {
    throw error.within(fmt::format("making the mesh '{}'", plan->name));
  }
}

Builder::MadeMesh Builder::make_bare(const shot::MeshPlan& plan) {
  const volume::LevelSet* surface = plan.given ? nullptr : &level_set(plan.volume);
  const Stopwatch watch(seconds_);
  mesh::LargeComponents pieces =
      surface ? make_mesh(plan, *surface, room(), progress_) : make_mesh(plan);
  return {std::make_shared<const mesh::Mesh>(std::move(pieces.mesh)), pieces.removed};
}

Builder::MadeMesh Builder::make_worn(const shot::MeshPlan& plan) {
  const bool refine = plan.cells->refine.value_or(!plan.volume);
  if (plan.volume && !refine && plan.volume->voxel > 1.01 * plan.cells->spacing)
    warn(plan.cells->where,
         fmt::format("the voxels of '{}' are larger than the cells, so that not all of these can "
                     "show",
                     plan.volume->name),
         "use smaller voxels, a larger spacing or refine true");
  const SkinPtr skin = this->skin(plan.cells);
  const shot::MeshPtr under = shot::below(plan);
  mesh::MeshPtr bare = mesh(under);
  const Stopwatch watch(seconds_);
  if (refine) bare = refined_for(*plan.cells, *bare, room());
  Worn made = wear(*bare, *skin, *plan.cells, progress_);
  // A sliver or two of a hundred thousand triangles nobody sees.
  if (made.turned > bare->triangles.size() / 2000)
    warn(plan.cells->where,
         fmt::format(
             "where cells move the mesh '{}' it folds: {} of its {} triangles are turned over",
             plan.name, made.turned, bare->triangles.size()),
         "let them move less, or make a volume of it and a mesh of that: volume NAME on " +
             plan.name);
  const auto worn = std::make_shared<const mesh::Mesh>(std::move(made.mesh));
  if (worn->triangles.empty() && !bare->triangles.empty())
    warn(plan.cells->where, fmt::format("nothing is left of the mesh '{}'", plan.name),
         "all of its cells are gone and 'holes' cuts them away");
  return {worn, components_removed(under)};
}

Builder::MadeMesh Builder::make_merged(const shot::MeshPlan& plan) {
  std::vector<mesh::MeshPtr> parts;
  MadeMesh made;
  for (const shot::MeshPtr& part : plan.parts) {
    parts.push_back(mesh(part));
    made.components_removed += components_removed(part);
  }
  made.mesh = std::make_shared<const mesh::Mesh>(merged(parts));
  return made;
}

std::shared_ptr<const field::SampledGrid> Builder::solid(const shot::MeshPtr& plan) {
  return plan->volume ? volume::sampled_grid(level_set(plan->volume)) : nullptr;
}

SkinPtr Builder::begun(const shot::CellsPlan& plan) const {
  const auto same = [](const shot::MeshPtr& a, const shot::MeshPtr& b) { return *a == *b; };
  for (const auto* runs : {&skins_, &begun_})
    for (const auto& [other, skin] : *runs)
      if (plan.still && other->still && other->name == plan.name &&
          skin->simulation.step() <= plan.length() &&
          std::equal(other->on.begin(), other->on.end(), plan.on.begin(), plan.on.end(), same))
        return skin;
  return nullptr;
}

SkinPtr Builder::skin(const shot::CellsPtr& plan) {
  if (const auto known = skins_.find(plan); known != skins_.end()) return known->second;
  std::vector<Ground> grounds;
  for (const shot::MeshPtr& each : plan->on) grounds.push_back({mesh(each), solid(each)});
  const Stopwatch watch(seconds_);
  try {
    SkinRun how{nullptr, options_.checkpoint.get()};
    if (const auto begun = begun_.find(plan); begun != begun_.end()) how.from = begun->second;
    auto made = std::make_shared<const Skin>(make_skin(*plan, grounds, room(), progress_, how));
    if (how.from) held_ -= how.from->simulation.bytes(), begun_.erase(plan);
    held_ += made->simulation.bytes();
    return skins_.emplace(plan, std::move(made)).first->second;
  } catch (Error& error) {
    throw error.within(fmt::format("making the cells '{}'", plan->name));
  }
}

void Builder::require_surface_room(const shot::MeshPtr& plan) const {
  const shot::VolumePlan& volume = *plan->volume;
  if (level_sets_.count(plan->volume) || volume.field.bounds().isEmpty()) return;
  try {
    const auto estimate = volume::estimate(volume.field, voxelize_options(volume, room()));
    require_memory(estimate.bytes + surface_bytes(estimate.surface_area, volume.voxel), room(),
                   fmt::format("a surface and its grid with voxels of {} m", volume.voxel));
  } catch (Error& error) {
    throw of_volume(volume, error, fmt::format("making the surface of '{}'", plan->name));
  }
}

volume::SurfaceBricksPtr Builder::surface(const shot::MeshPtr& plan) {
  if (const auto known = made_surface(plan)) return known;
  require_surface_room(plan);
  const volume::LevelSet& grid = level_set(plan->volume);
  const Stopwatch watch(seconds_);
  const auto active = static_cast<double>(grid.statistics().active_voxels);
  const double area = area_of_band(active, *plan->volume);
  try {
    require_memory(surface_bytes(area, plan->volume->voxel), room(), "the surface");
    auto made = std::make_shared<const volume::SurfaceBricks>(grid, plan->smallest_piece);
    held_ += made->bytes();
    return surfaces_.emplace(plan, std::move(made)).first->second;
  } catch (Error& error) {
    throw error.within(fmt::format("making the surface of '{}'", plan->name));
  }
}

size_t Builder::components_removed(const shot::MeshPtr& plan) const {
  if (const MadeMesh* known = made(plan)) return known->components_removed;
  const auto surface = made_surface(plan);
  return surface ? surface->components_removed() : 0;
}

}  // namespace vug::building
