// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/building/level_set_for_files.h>
#include <vug/building/memory_estimate.h>
#include <vug/meshing/exact_distances.h>

#include <fmt/format.h>

namespace vug::building {
namespace {

using shot::DistanceValues;

constexpr const char* kDistance = "vug:distance";

/// Level sets of meshes, and of fields with this guarantee, contain exact distances already.
bool is_exact(const shot::VolumePlan& plan, const field::Field& sampled) {
  return plan.source_mesh || sampled.exactness() == field::Exactness::exact;
}

volume::LevelSet exact(Builder& builder, const shot::VolumePtr& plan) {
  const auto options = voxelize_options(*plan, builder.memory_budget());
  const field::Field sampled =
      plan->source_mesh ? field::Field() : volume::field_in_region(plan->field, options);
  if (is_exact(*plan, sampled)) return builder.level_set(plan);
  // The polygons take the memory of a mesh.
  builder.require_mesh_memory(shot::plain_mesh(plan));
  const volume::LevelSet& bounds = builder.level_set(plan);
  const volume::Statistics size = bounds.statistics();
  require_memory(static_cast<double>(size.memory_bytes) +
                     meshing_bytes(static_cast<double>(size.active_voxels), 2 * plan->half_width),
                 builder.memory_budget(), fmt::format("the exact distances of '{}'", plan->name),
                 "use a larger voxel, or 'distance: bound' in its level_set");
  const Progress::Product product(builder.progress(), plan->name);
  try {
    return meshing::exact_distances(bounds, sampled, builder.progress());
  } catch (Error& error) {
    throw error.within(fmt::format("making the volume '{}'", plan->name));
  }
}

}  // namespace

volume::LevelSet level_set_for_files(Builder& builder, const shot::VolumePtr& plan,
                                     DistanceValues automatic) {
  const bool requested = plan->distance != DistanceValues::automatic;
  const bool is_exact = (requested ? plan->distance : automatic) == DistanceValues::exact;
  if (plan->fog || (!requested && !is_exact)) return builder.level_set(plan);
  const volume::LevelSet made = is_exact ? exact(builder, plan) : builder.level_set(plan);
  return volume::LevelSet(made.with({{kDistance, is_exact ? "exact" : "bound"}}));
}

}  // namespace vug::building
