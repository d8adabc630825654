// SPDX-License-Identifier: Apache-2.0
// The materials of the rock of a volume, at the vertices of its mesh, in the band of its level set
// and at cells on its surface.
#pragma once

#include <vug/cells/network.h>
#include <vug/mesh/mesh.h>
#include <vug/shot/cells_plan.h>
#include <vug/shot/shot.h>
#include <vug/volume/level_set.h>
#include <vug/volume/points.h>

#include <string>
#include <vector>

namespace vug::building {

/// The names of the materials of the volume's field, ordered; none for the volume of a mesh. Fields
/// that have not been computed do not contribute; see field::materials_of.
std::vector<std::string> materials_of(const shot::VolumePlan& plan);

/// Adds an attribute of weights for each material of the volume; none for a volume without
/// materials. See mesh::weight_attribute. The vertices of a mesh that is not polished lie up to
/// half a voxel off the surface, where thin layers have other weights: theirs are those of the
/// surface next to them.
void add_rock_weights(mesh::Mesh& mesh, const shot::VolumePlan& plan, bool polished);

/// Grids on the level set's lattice, with values in its active voxels and 0 elsewhere: for each
/// material the weight `w_NAME`, and `material`, the number of the largest weight, counted from 1
/// in the order of the names. The metadata `vug:materials` lists the names, separated by commas.
/// `prefix` precedes the names of the grids. Error(too_large) if `memory` bytes do not suffice.
std::vector<volume::Grid> rock_grids(const shot::VolumePlan& plan,
                                     const volume::LevelSet& level_set, const std::string& prefix,
                                     uint64_t memory);

/// Adds the attributes `w_NAME` and `material`, numbered in the same way, to the points of cells:
/// the materials of the supports' volumes at the undisplaced cells, 0 for cells on other supports.
/// Returns the names of the materials; without any, nothing is added.
std::vector<std::string> add_rock_weights(volume::Points& points, const shot::CellsPlan& plan,
                                          const cells::Network& network);

/// The metadata of grids with numbers of materials, which lists their names.
inline constexpr const char* kMaterialNames = "vug:materials";
inline constexpr const char* kMaterialNumber = "material";

}  // namespace vug::building
