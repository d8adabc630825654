// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/building/memory_estimate.h>
#include <vug/building/product_keys.h>
#include <vug/farm/estimate.h>
#include <vug/field/deferred.h>
#include <vug/render/paths/training.h>
#include <vug/render/render.h>
#include <vug/shot/queries.h>

#include <algorithm>
#include <optional>
#include <set>

namespace vug::farm {
namespace {

// Of a film pixel with the usual AOVs.
constexpr double kPixelBytes = 200;
constexpr double kVertexBytes = 2 * sizeof(Vec3f);

/// The size of the volume's level set if it is in the store, which is much faster than an estimate.
std::optional<volume::VoxelizeEstimate> stored_size(const shot::VolumePlan& volume,
                                                    const building::StoreUse& stored) {
  if (!stored.store) return std::nullopt;
  const auto entry = stored.store->find(stored.complete(building::level_set_key(volume)));
  if (!entry) return std::nullopt;
  try {
    const auto found = building::ProductFile<volume::LevelSet>::read(entry->object).statistics();
    volume::VoxelizeEstimate out;
    out.active_voxels = static_cast<double>(found.active_voxels);
    out.bytes = static_cast<double>(found.memory_bytes);
    return out;
  } catch (const Error&) {  // another process removed the file meanwhile
    return std::nullopt;
  }
}

volume::VoxelizeEstimate sampled_size(const shot::VolumePlan& volume, Progress& progress) {
  field::compute_deferred(volume.field, progress);
  return run_stage(progress, "estimating the cost", [&] {
    return volume::estimate(volume.field, building::voxelize_options(volume, 0));
  });
}

}  // namespace

PictureCost estimate_picture(const picture::PicturePlan& plan, int cores, const Rates& rates,
                             Progress& progress, const building::StoreUse& stored) {
  PictureCost out;
  std::set<shot::VolumePtr> volumes;
  for (const shot::MeshPtr& mesh : shot::shown_meshes(*plan.shown))
    if (mesh->volume && !mesh->volume->source_mesh) volumes.insert(mesh->volume);
  double meshing = 0;
  for (const shot::VolumePtr& volume : volumes) {
    const Progress::Product product(progress, volume->name);
    const auto known = stored_size(*volume, stored);
    const volume::VoxelizeEstimate grid = known ? *known : sampled_size(*volume, progress);
    out.voxels += grid.active_voxels;
    // Two triangles and one vertex for each of the voxels that the surface crosses.
    const double vertices = 1.5 * grid.active_voxels / (2 * volume->half_width);
    out.triangles += 2 * vertices;
    out.bytes += grid.bytes + kVertexBytes * vertices;
    meshing =
        std::max(meshing, building::meshing_bytes(grid.active_voxels, 2 * volume->half_width));
  }
  const shot::RenderSettings& settings = plan.render.settings;
  const double pixels = 1.0 * settings.size.at(0) * settings.size.at(1);
  out.samples = pixels * settings.spp;
  // The mesh is polished before the ray tree is built.
  out.bytes += std::max(meshing, render::kTriangleBytes * out.triangles + kPixelBytes * pixels);
  out.build_seconds =
      (out.voxels / rates.voxels + out.triangles / rates.triangles) / std::max(1, cores);
  out.start_seconds =
      (rates.start_seconds + out.triangles / rates.loaded_triangles) / std::max(1, cores);
  out.render_seconds = out.samples / rates.samples / std::max(1, cores);
  out.learn_seconds =
      static_cast<double>(render::training_paths(static_cast<uint64_t>(out.samples))) /
      rates.samples / std::max(1, cores);
  return out;
}

}  // namespace vug::farm
