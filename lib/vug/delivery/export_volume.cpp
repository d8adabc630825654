// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/building/level_set_for_files.h>
#include <vug/building/rock_weights.h>
#include <vug/delivery/export_volume.h>
#include <vug/delivery/write_products.h>
#include <vug/volume/density.h>

#include <fmt/format.h>

namespace vug::delivery {
namespace {

/// A level set of the air of a cave has the opposite sign of that of the rock.
std::string grid_name(const shot::VolumePlan& plan) {
  if (plan.fog) return "density";
  return plan.name == "air" ? "air" : "surface";
}

/// Replaces the density by all grids of the cloud.
void add_cloud(const building::Builder& builder, const render::Medium& cloud,
               const volume::Grid& density, bool half, ExportVolume& out) {
  // Vectors, numbers and the position of each voxel, before constant blocks are compressed.
  constexpr double kBytes = 32;
  require_memory(kBytes * static_cast<double>(density.statistics().active_voxels),
                 builder.memory_budget(), fmt::format("the grids of '{}'", out.name),
                 "use larger voxels");
  const render::MediumPtr medium =
      cloud.with_density(std::make_shared<const volume::Density>(density));
  std::optional<render::MediumData> data = medium ? medium->as_data(&density) : std::nullopt;
  if (!data) return;
  out.medium = data->medium;
  out.grids.clear();
  for (const volume::Grid& grid : data->grids) out.grids.push_back(grid.stored_as_half(half));
}

}  // namespace

ExportVolume export_volume(building::Builder& builder, const shot::VolumePtr& plan) {
  const volume::LevelSet level_set =
      building::level_set_for_files(builder, plan, shot::DistanceValues::exact);
  const volume::Grid grid = volume_grid(*plan, level_set).named(grid_name(*plan));
  ExportVolume out{plan->name, {grid}, {}};
  if (!plan->fog)
    for (volume::Grid& rock : building::rock_grids(*plan, level_set, "", builder.memory_budget()))
      out.grids.push_back(std::move(rock));
  for (const shot::MediumPlan& each : builder.shot().media)
    if (each.volume == plan && !out.medium) add_cloud(builder, *each.medium, grid, plan->half, out);
  return out;
}

bool has_own_grids(const shot::MediumPlan& plan) {
  return !plan.volume && plan.medium->has_grids();
}

ExportVolume export_medium(const shot::MediumPlan& plan) {
  ExportVolume out{plan.name, {}, {}};
  std::optional<render::MediumData> data = plan.medium->as_data(nullptr);
  if (data) out.grids = std::move(data->grids), out.medium = data->medium;
  return out;
}

}  // namespace vug::delivery
