// What the work for a shot's products takes, said before it is done.
#pragma once

#include <vug/mesh/mesh.h>
#include <vug/shot/shot.h>
#include <vug/volume/voxelize.h>

namespace vug::building {

volume::VoxelizeOptions voxelize_options(const shot::VolumePlan& plan, uint64_t max_memory);

uint64_t bytes_of(const mesh::Mesh& mesh);

/// Peak of making and polishing a mesh of a band that is so many voxels wide.
double meshing_bytes(double active_voxels, double band);
/// Peak of a surface without a mesh, with what tells its pieces apart.
double surface_bytes(double area, double voxel);
/// Square metres of the surface in a band of so many active voxels.
double area_of_band(double active_voxels, const shot::VolumePlan& plan);
/// No grid of the plan has more active voxels: as if every voxel were in the band.
double max_active_voxels(const shot::VolumePlan& plan);

}  // namespace vug::building
