// SPDX-License-Identifier: Apache-2.0
// Memory estimates for building a scene's products, made before the work starts.
#pragma once

#include <vug/mesh/mesh.h>
#include <vug/shot/shot.h>
#include <vug/volume/voxelize.h>

namespace vug::building {

volume::VoxelizeOptions voxelize_options(const shot::VolumePlan& plan, uint64_t max_memory);

uint64_t bytes_of(const mesh::Mesh& mesh);

/// Peak memory in bytes for building and polishing a mesh from a band `band` voxels wide.
double meshing_bytes(double active_voxels, double band);
/// Peak memory in bytes for `names` labels of such a mesh, which each vertex stores.
double label_bytes(double active_voxels, double band, size_t names);
/// Peak memory in bytes for the weights of `materials` rock materials of such a mesh.
double rock_weight_bytes(double active_voxels, double band, size_t materials);
/// Peak memory in bytes of a surface for direct ray tracing, including the labels of its
/// components.
double surface_bytes(double area, double voxel);
/// Area in square metres of the surface in a band of `active_voxels`.
double area_of_band(double active_voxels, const shot::VolumePlan& plan);
/// Upper bound for the active voxels of the plan: every voxel of its box.
double max_active_voxels(const shot::VolumePlan& plan);

}  // namespace vug::building
