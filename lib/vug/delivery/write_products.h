// SPDX-License-Identifier: Apache-2.0
// Writes the products of a shot to files.
#pragma once

#include <vug/building/builder.h>
#include <vug/mesh/comments.h>
#include <vug/volume/io.h>

#include <filesystem>

namespace vug::delivery {

/// The paths that write_products returns.
std::vector<std::filesystem::path> product_paths(const shot::Shot& shot,
                                                 const std::filesystem::path& folder,
                                                 const std::string& frame = {});

/// Writes all declared products into `folder`, each file completely or not at all; NAME is the
/// shot's name: all volumes in NAME.vdb, with the grids of cells on them; the only mesh and a mesh
/// with the shot's name in NAME.ply (.obj, .stl), others in NAME_MESH.ply; points of cells in
/// NAME_CELLS.vdb and their table in NAME_CELLS.csv. The frame number precedes the extension:
/// NAME.0012.vdb. Returns the paths in the order of writing. Error(io) before the work if one of
/// them cannot be written.
std::vector<std::filesystem::path> write_products(building::Builder& builder,
                                                  const std::filesystem::path& folder,
                                                  const std::string& frame = {});

/// Writes all volumes, with the grids of cells on them, to one file.
void write_volumes(building::Builder& builder, const std::filesystem::path& vdb);

/// The grid of a volume for files, with its name: the level set, or the density of a fog.
volume::Grid volume_grid(const shot::VolumePlan& plan, const volume::LevelSet& level_set);

/// Write options with the provenance of the shot's grids.
volume::WriteOptions write_options(const shot::Shot& shot);
/// Comments with the provenance of the shot's meshes.
mesh::Comments mesh_comments(const shot::Shot& shot);

}  // namespace vug::delivery
