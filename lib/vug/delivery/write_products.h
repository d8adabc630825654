// Products to files.
#pragma once

#include <vug/building/builder.h>
#include <vug/mesh/comments.h>
#include <vug/volume/io.h>

#include <filesystem>

namespace vug::delivery {

/// The paths that write_products gives.
std::vector<std::filesystem::path> product_paths(const shot::Shot& shot,
                                                 const std::filesystem::path& folder,
                                                 const std::string& frame = {});

/// Writes everything the shot declares into `folder`, each file whole or not at all: all volumes
/// in NAME.vdb, with what cells on them carry beside them; the only mesh and one of the shot's name
/// in NAME.ply (.obj, .stl), others in NAME_MESH.ply; points of cells in NAME_CELLS.vdb and their
/// table in NAME_CELLS.csv, where NAME is the shot's. A frame's number stands before the extension
/// with a stop: NAME.0012.vdb. Gives the paths in the order they were written. Error(io) before the
/// work where one of them cannot be written.
std::vector<std::filesystem::path> write_products(building::Builder& builder,
                                                  const std::filesystem::path& folder,
                                                  const std::string& frame = {});

/// The first of these files under any name: all volumes, with what cells on them carry.
void write_volumes(building::Builder& builder, const std::filesystem::path& vdb);

/// What files hold of a volume, under its name: the level set, or the density of a fog.
volume::Grid volume_grid(const shot::VolumePlan& plan, const volume::LevelSet& level_set);

/// What files of the shot's grids tell about where they come from.
volume::WriteOptions write_options(const shot::Shot& shot);
/// The same of its meshes.
mesh::Comments mesh_comments(const shot::Shot& shot);

}  // namespace vug::delivery
