// SPDX-License-Identifier: Apache-2.0
#include <vug/building/memory_estimate.h>
#include <vug/field/material_mix.h>
#include <vug/volume/surface_bricks.h>

namespace vug::building {

volume::VoxelizeOptions voxelize_options(const shot::VolumePlan& plan, uint64_t max_memory) {
  volume::VoxelizeOptions options;
  options.voxel = plan.voxel;
  options.half_width = plan.half_width;
  options.repair = plan.repair;
  options.max_memory = max_memory;
  if (plan.from) options.region = Box3d(*plan.from, *plan.to);
  return options;
}

uint64_t bytes_of(const mesh::Mesh& mesh) {
  uint64_t bytes =
      2 * sizeof(Vec3f) * mesh.positions.size() + sizeof(Vec3i) * mesh.triangles.size();
  for (const mesh::Attribute& attribute : mesh.attributes)
    bytes += sizeof(float) * attribute.values.size();
  return bytes;
}

namespace {

// A surface of area A has 1.5 A / voxel^2 vertices, averaged over orientations.
double vertices_of(double active_voxels, double band) { return 1.5 * active_voxels / band; }

}  // namespace

// Measured for a smooth and a rough sphere.
double meshing_bytes(double active_voxels, double band) {
  constexpr double kVertexBytes = 420;
  return kVertexBytes * vertices_of(active_voxels, band);
}

// Two values, the nearest label and a number for each name; see add_labels.
double label_bytes(double active_voxels, double band, size_t names) {
  if (names == 0) return 0;
  const double bytes =
      2 * sizeof(float) + sizeof(size_t) + static_cast<double>(names) * sizeof(float);
  return bytes * vertices_of(active_voxels, band);
}

double rock_weight_bytes(double active_voxels, double band, size_t materials) {
  if (materials == 0) return 0;
  const double bytes = sizeof(field::MaterialMix) + static_cast<double>(materials) * sizeof(float);
  return bytes * vertices_of(active_voxels, band);
}

double surface_bytes(double area, double voxel) {
  constexpr double kBrickBytes = sizeof(volume::SurfaceBricks::Brick) + 3000;
  return kBrickBytes * volume::brick_estimate(area, voxel);
}

double area_of_band(double active_voxels, const shot::VolumePlan& plan) {
  return active_voxels * plan.voxel * plan.voxel / (2 * plan.half_width);
}

double max_active_voxels(const shot::VolumePlan& plan) {
  const Vec3d size = (plan.from ? Box3d(*plan.from, *plan.to) : plan.field.bounds()).size();
  double voxels = 1;
  for (int axis = 0; axis < 3; ++axis) voxels *= size[axis] / plan.voxel + 2 * plan.half_width + 2;
  return voxels;
}

}  // namespace vug::building
