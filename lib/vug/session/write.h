// Products to files.
#pragma once

#include <vug/session/build.h>

#include <filesystem>

namespace vug::session {

/// The paths that write_products gives.
std::vector<std::filesystem::path> product_paths(const Shot& shot,
                                                 const std::filesystem::path& folder);

/// Writes everything the shot declares into `folder`, each file whole or not at all: all volumes
/// in NAME.vdb, the only mesh and one of the shot's name in NAME.ply (.obj, .stl), others in
/// NAME_MESH.ply, where NAME is the shot's. Gives the paths in the order they were written.
/// Error(io) before the work where one of them cannot be written.
std::vector<std::filesystem::path> write_products(Builder& builder,
                                                  const std::filesystem::path& folder);

}  // namespace vug::session
