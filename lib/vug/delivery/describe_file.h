// What is in a product's file, as data.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace vug::delivery {

/// .vdb: grids with class, type, voxel size, active voxels, bounds, metadata, points; pictures:
/// size, channels, header texts; meshes: vertices, triangles, attributes, bounds; tables: rows and
/// columns.
/// Error(bad_input) for other files and for broken ones.
nlohmann::ordered_json describe_file(const std::filesystem::path& file);

}  // namespace vug::delivery
