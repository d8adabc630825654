// SPDX-License-Identifier: Apache-2.0
// The memory that the products of a Builder need, before they are made, and the refusal of too
// large ones.
#include <vug/base/memory.h>
#include <vug/building/builder.h>
#include <vug/building/cell_layer.h>
#include <vug/building/memory_estimate.h>
#include <vug/building/product_keys.h>
#include <vug/building/rock_weights.h>
#include <vug/field/deferred.h>
#include <vug/metrics/surface.h>
#include <vug/shot/cells_plan.h>
#include <vug/shot/queries.h>
#include <vug/volume/fitting_voxel.h>

#include <fmt/format.h>

namespace vug::building {

uint64_t Builder::memory_budget() const {
  if (options_.max_memory == 0) return available_memory();
  return options_.max_memory > held_ ? options_.max_memory - held_ : 1;
}

Error Builder::volume_error(const shot::VolumePlan& plan, Error& error, std::string doing) {
  if (error.code() == ErrorCode::bad_input && !error.where().known()) return error.at(plan.where);
  return error.within(std::move(doing));
}

void Builder::compute_deferred(const shot::Shot& part) {
  for (const shot::ObjectPlan& object : shot::shown_objects(part)) {
    const shot::VolumePtr& plan = object.mesh->volume;
    if (!plan) continue;
    const shot::MeshPtr bare =
        object.mesh->cells ? shot::mesh_without_cells(*object.mesh) : object.mesh;
    if (object.direct ? products_.contains(level_set_key(*plan)) : is_stored(*bare)) continue;
    const Progress::Product product(progress_, plan->name);
    field::compute_deferred(plan->field, progress_, memory_budget());
  }
}

const volume::VoxelizeEstimate& Builder::estimate(const shot::VolumePtr& plan) const {
  if (const auto known = estimates_.find(plan); known != estimates_.end()) return known->second;
  const Progress::Product product(progress_, plan->name);
  field::compute_deferred(plan->field, progress_, memory_budget());
  const auto made = run_stage(progress_, "estimating the memory", [&] {
    return volume::estimate(plan->field, voxelize_options(*plan, memory_budget()));
  });
  return estimates_.emplace(plan, made).first->second;
}

double Builder::area_of(const shot::VolumePtr& plan) {
  // An estimate would compute the deferred parts of the field.
  if (!plan->source_mesh && products_.contains(level_set_key(*plan))) level_set(plan);
  if (const auto held = level_sets_.find(plan); held != level_sets_.end())
    return area_of_band(static_cast<double>(held->second.statistics().active_voxels), *plan);
  if (plan->source_mesh && plan->source_mesh->volume) return area_of(plan->source_mesh->volume);
  if (plan->field.bounds().isEmpty()) return 0;
  return estimate(plan).surface_area;
}

double Builder::max_area_of(const shot::VolumePtr& plan) {
  if (plan->source_mesh || plan->field.bounds().isEmpty()) return area_of(plan);
  return area_of_band(max_active_voxels(*plan), *plan);
}

void Builder::require_mesh_memory(const shot::MeshPtr& plan) {
  if (cached(plan) || (plan->labels.empty() && is_stored(*plan))) return;
  for (const shot::MeshPtr& part : plan->parts) require_mesh_memory(part);
  if (plan->cells && cell_layers_.count(plan->cells) == 0) {
    for (const shot::MeshPtr& support : plan->cells->on) require_mesh_memory(support);
    const auto area = [&](const auto& area_of_volume) {
      double sum = 0;
      for (const shot::MeshPtr& support : plan->cells->on) {
        if (support->volume) sum += area_of_volume(support->volume);
        if (support->file_mesh) sum += metrics::area(*support->file_mesh);
      }
      return sum;
    };
    // The estimate of an area can take half as long as the voxels: not if a filled box would fit.
    const double most = area([&](const shot::VolumePtr& volume) { return max_area_of(volume); });
    if (!cells_fit(*plan->cells, most, memory_budget()))
      require_cell_memory(*plan->cells,
                          area([&](const shot::VolumePtr& volume) { return area_of(volume); }),
                          memory_budget());
  }
  if (plan->cells || !plan->volume) return;
  const shot::VolumePlan& volume = *plan->volume;
  if (volume.source_mesh) return require_mesh_memory(volume.source_mesh);
  if (level_sets_.count(plan->volume) || volume.field.bounds().isEmpty()) return;
  const size_t labels = shot::label_names(plan->labels).size();
  const auto bytes_of_mesh = [&](double active_voxels) {
    const double band = 2 * volume.half_width;
    return meshing_bytes(active_voxels, band) + label_bytes(active_voxels, band, labels) +
           rock_weight_bytes(active_voxels, band, materials_of(volume).size());
  };
  if (bytes_of_mesh(max_active_voxels(volume)) <= static_cast<double>(memory_budget())) return;
  try {
    const auto& estimated = estimate(plan->volume);
    const double bytes = estimated.bytes + bytes_of_mesh(estimated.active_voxels);
    require_memory(bytes, memory_budget(),
                   fmt::format("a mesh and its grid with voxels of {} m", volume.voxel),
                   volume::fitting_voxel_hint(volume.voxel, bytes, memory_budget()));
  } catch (Error& error) {
    throw volume_error(volume, error, fmt::format("making the mesh '{}'", plan->name));
  }
}

void Builder::require_surface_memory(const shot::MeshPtr& plan) {
  const shot::VolumePlan& volume = *plan->volume;
  if (level_sets_.count(plan->volume) || products_.contains(level_set_key(volume))) return;
  if (volume.field.bounds().isEmpty()) return;
  try {
    const auto& estimated = estimate(plan->volume);
    const double bytes = estimated.bytes + surface_bytes(estimated.surface_area, volume.voxel);
    require_memory(bytes, memory_budget(),
                   fmt::format("a surface and its grid with voxels of {} m", volume.voxel),
                   volume::fitting_voxel_hint(volume.voxel, bytes, memory_budget()));
  } catch (Error& error) {
    throw volume_error(volume, error, fmt::format("making the surface of '{}'", plan->name));
  }
}

}  // namespace vug::building
