#include <vug/base/memory.h>
#include <vug/mesh/pieces.h>
#include <vug/meshing/polygonize.h>
#include <vug/paint/paint.h>
#include <vug/session/build.h>
#include <vug/session/wear.h>
#include <vug/volume/samples.h>
#include <vug/volume/voxelize.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <set>

namespace vug::session {
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
std::string why_empty(const VolumePlan& plan) {
  const Box3d& bounds = plan.field.bounds();
  if (bounds.isEmpty()) return "its solid is empty";
  if (plan.from && !bounds.intersects(Box3d(*plan.from, *plan.to)))
    return "its solid lies outside of 'from' and 'to'";
  return "its solid is empty or thinner than a voxel";
}

uint64_t bytes_of(const mesh::Mesh& mesh) {
  uint64_t bytes =
      2 * sizeof(Vec3f) * mesh.positions.size() + sizeof(Vec3i) * mesh.triangles.size();
  for (const mesh::Attribute& attribute : mesh.attributes)
    bytes += sizeof(float) * attribute.values.size();
  return bytes;
}

void add_colors(mesh::Mesh& mesh, const paint::Paint& paint, const volume::LevelSet& surface) {
  const auto solid = volume::samples(surface);
  std::vector<paint::Spot> spots(mesh.positions.size());
  for (size_t i = 0; i < spots.size(); ++i)
    spots[i] = {Vec3d(mesh.positions[i]), Vec3d(mesh.normals.at(i)).normalized(), solid.get()};
  mesh::Attribute color{"Cd", 3, {}};
  color.values.reserve(3 * spots.size());
  for (const Vec3f& rgb : paint::colors(paint, spots))
    for (int c = 0; c < 3; ++c) color.values.push_back(rgb[c]);
  mesh.attributes.push_back(std::move(color));
}

/// Peak of making and polishing a mesh of a band that is so many voxels wide. A surface of area A
/// has 1.5 A / voxel^2 vertices on average over its directions; each took 420 bytes, measured with
/// a ball and a rough one.
double meshing_bytes(double active_voxels, double band) {
  constexpr double kVertexBytes = 420;
  return kVertexBytes * 1.5 * active_voxels / band;
}

/// Peak of a surface without a mesh, with what tells its pieces apart.
double surface_bytes(double area, double voxel) {
  constexpr double kBrickBytes = sizeof(volume::SurfaceBricks::Brick) + 3000;
  return kBrickBytes * volume::brick_estimate(area, voxel);
}

volume::VoxelizeOptions voxelize_options(const VolumePlan& plan, uint64_t max_memory) {
  volume::VoxelizeOptions options;
  options.voxel = plan.voxel;
  options.half_width = plan.half_width;
  options.repair = plan.repair;
  options.max_memory = max_memory;
  if (plan.from) options.region = Box3d(*plan.from, *plan.to);
  return options;
}

/// No mesh of the plan needs more: as if every voxel were in the band.
double most_meshing_bytes(const VolumePlan& plan) {
  const Vec3d size = (plan.from ? Box3d(*plan.from, *plan.to) : plan.field.bounds()).size();
  double voxels = 1;
  for (int axis = 0; axis < 3; ++axis) voxels *= size[axis] / plan.voxel + 2 * plan.half_width + 2;
  return meshing_bytes(voxels, 2 * plan.half_width);
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

const Builder::MadeMesh* Builder::made(const MeshPtr& plan) const {
  if (const auto found = meshes_.find(plan); found != meshes_.end()) return &found->second;
  for (const auto& [other, mesh] : meshes_)
    if (*other == *plan) return &mesh;
  return nullptr;
}

volume::SurfaceBricksPtr Builder::made_surface(const MeshPtr& plan) const {
  for (const auto& [other, surface] : surfaces_)
    if (other->volume == plan->volume && other->smallest_piece == plan->smallest_piece)
      return surface;
  return nullptr;
}

void Builder::take_over(Builder&& other) {
  std::set<VolumePtr> volumes(shot_.volumes.begin(), shot_.volumes.end());
  volumes.insert(shot_.medium_volume);
  std::vector<MeshPtr> meshes = meshes_of(shot_);
  for (const ObjectPlan& object : shot_.objects) meshes.push_back(object.mesh);
  for (const PlacePlan& place : shot_.places)
    for (const Model& model : place.of)
      if (model.mesh) meshes.push_back(model.mesh);
  for (const MeshPtr& plan : meshes) {
    volumes.insert(plan->volume);
    const MadeMesh* mesh = other.made(plan);
    if (mesh && meshes_.emplace(plan, *mesh).second) held_ += bytes_of(*mesh->mesh);
  }
  for (const MeshPtr& plan : meshes)
    if (const auto known = other.made_surface(plan); known && surfaces_.emplace(plan, known).second)
      held_ += known->bytes();
  for (auto& [plan, grid] : other.level_sets_)
    if (volumes.count(plan)) {
      held_ += grid.statistics().memory_bytes;
      level_sets_.emplace(plan, std::move(grid));
    }
  seconds_ += other.seconds_;
  other.level_sets_.clear(), other.meshes_.clear(), other.surfaces_.clear();
}

const volume::LevelSet& Builder::level_set(const VolumePtr& plan) {
  if (const auto found = level_sets_.find(plan); found != level_sets_.end()) return found->second;
  const Stopwatch watch(seconds_);
  const volume::VoxelizeOptions voxelize = voxelize_options(*plan, room());
  try {
    const volume::LevelSet& made =
        level_sets_.emplace(plan, volume::voxelize(plan->field, voxelize, progress_)).first->second;
    held_ += made.statistics().memory_bytes;
    if (!made.holds_solid())
      warn(plan->where, fmt::format("the volume '{}' comes out empty", plan->name),
           why_empty(*plan));
    return made;
  } catch (Error& error) {
    throw error.within(fmt::format("making the volume '{}'", plan->name));
  }
}

void Builder::require_room(const MeshPtr& plan) const {
  const VolumePlan& volume = *plan->volume;
  if (level_sets_.count(plan->volume) || volume.field.bounds().isEmpty()) return;
  if (most_meshing_bytes(volume) <= static_cast<double>(room())) return;
  try {
    const auto estimate = volume::estimate(volume.field, voxelize_options(volume, room()));
    require_memory(estimate.bytes + meshing_bytes(estimate.active_voxels, 2 * volume.half_width),
                   room(), fmt::format("a mesh and its grid with voxels of {} m", volume.voxel));
  } catch (Error& error) {
    throw error.within(fmt::format("making the mesh '{}'", plan->name));
  }
}

std::shared_ptr<const mesh::Mesh> Builder::mesh(const MeshPtr& plan) {
  if (const MadeMesh* known = made(plan)) return known->mesh;
  require_room(plan);
  const volume::LevelSet& surface = level_set(plan->volume);
  const Stopwatch watch(seconds_);
  meshing::PolygonizeOptions polygonize;
  polygonize.adaptivity = plan->adaptivity;
  polygonize.polish = plan->polish;
  const field::Field* exact = plan->polish ? &plan->volume->field : nullptr;
  try {
    const auto active = static_cast<double>(surface.statistics().active_voxels);
    require_memory(meshing_bytes(active, 2 * plan->volume->half_width), room(), "the mesh");
    mesh::LargePieces pieces = mesh::large_pieces(
        meshing::polygonize(surface, exact, polygonize, progress_).mesh, plan->smallest_piece);
    if (plan->paint) add_colors(pieces.mesh, plan->paint, surface);
    for (const auto& cells : plan->cells) {
      wear(pieces.mesh, *cells, surface, room(), progress_);
      if (plan->volume->voxel > 1.01 * cells->spacing)
        warn(cells->where,
             fmt::format("the voxels of '{}' are larger than the cells, so that not all of these "
                         "can show",
                         plan->volume->name),
             "use smaller voxels or a larger spacing");
    }
    held_ += bytes_of(pieces.mesh);
    auto kept = std::make_shared<const mesh::Mesh>(std::move(pieces.mesh));
    return meshes_.emplace(plan, MadeMesh{std::move(kept), pieces.left_out}).first->second.mesh;
  } catch (Error& error) {
    throw error.within(fmt::format("making the mesh '{}'", plan->name));
  }
}

void Builder::require_surface_room(const MeshPtr& plan) const {
  const VolumePlan& volume = *plan->volume;
  if (level_sets_.count(plan->volume) || volume.field.bounds().isEmpty()) return;
  try {
    const auto estimate = volume::estimate(volume.field, voxelize_options(volume, room()));
    require_memory(estimate.bytes + surface_bytes(estimate.surface_area, volume.voxel), room(),
                   fmt::format("a surface and its grid with voxels of {} m", volume.voxel));
  } catch (Error& error) {
    throw error.within(fmt::format("making the surface of '{}'", plan->name));
  }
}

volume::SurfaceBricksPtr Builder::surface(const MeshPtr& plan) {
  if (const auto known = made_surface(plan)) return known;
  require_surface_room(plan);
  const volume::LevelSet& grid = level_set(plan->volume);
  const Stopwatch watch(seconds_);
  const auto active = static_cast<double>(grid.statistics().active_voxels);
  const double voxel = plan->volume->voxel;
  const double area = active * voxel * voxel / (2 * plan->volume->half_width);
  try {
    require_memory(surface_bytes(area, voxel), room(), "the surface");
    auto made = std::make_shared<const volume::SurfaceBricks>(grid, plan->smallest_piece);
    held_ += made->bytes();
    return surfaces_.emplace(plan, std::move(made)).first->second;
  } catch (Error& error) {
    throw error.within(fmt::format("making the surface of '{}'", plan->name));
  }
}

size_t Builder::pieces_left_out(const MeshPtr& plan) const {
  if (const MadeMesh* known = made(plan)) return known->pieces_left_out;
  const auto surface = made_surface(plan);
  return surface ? surface->pieces_left_out() : 0;
}

std::vector<MeshPtr> declared_meshes(const Shot& shot) {
  std::set<MeshPtr> bare;
  for (const MeshPtr& mesh : shot.meshes) bare.insert(mesh->bare);
  std::vector<MeshPtr> kept;
  std::copy_if(shot.meshes.begin(), shot.meshes.end(), std::back_inserter(kept),
               [&](const MeshPtr& mesh) { return bare.count(mesh) == 0; });
  return kept;
}

std::vector<MeshPtr> meshes_of(const Shot& shot) {
  if (!shot.meshes.empty()) return declared_meshes(shot);
  std::vector<MeshPtr> meshes;
  for (const VolumePtr& volume : shot.volumes) {
    if (volume->fog) continue;
    MeshPlan plan;
    plan.name = volume->name;
    plan.volume = volume;
    meshes.push_back(std::make_shared<const MeshPlan>(std::move(plan)));
  }
  return meshes;
}

}  // namespace vug::session
