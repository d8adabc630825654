// SPDX-License-Identifier: Apache-2.0
// A field's surface and its topology.
#pragma once

#include <vug/field/field.h>
#include <vug/mesh/topology.h>
#include <vug/volume/polygons.h>
#include <vug/volume/voxelize.h>

namespace vug::passages {

/// The polygons of the level set with this edge of voxels in metres.
inline mesh::Mesh surface_of(const field::Field& field, double voxel) {
  volume::VoxelizeOptions options;
  options.voxel = voxel;
  const volume::Polygons polygons = volume::polygons_of(volume::voxelize(field, options));
  mesh::Mesh mesh;
  mesh.positions = polygons.points;
  for (const auto& t : polygons.triangles) mesh.triangles.push_back({t[0], t[1], t[2]});
  for (const auto& q : polygons.quads) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return mesh;
}

inline mesh::Topology topology_of(const field::Field& field, double voxel) {
  return mesh::inspect(surface_of(field, voxel));
}

}  // namespace vug::passages
