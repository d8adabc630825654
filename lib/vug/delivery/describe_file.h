// SPDX-License-Identifier: Apache-2.0
// Describes the contents of a product file, as data.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace vug::delivery {

/// For .vdb files: grids with class, type, voxel size, active voxels, bounds, metadata, points. For
/// pictures: size, channels, header texts. For meshes: vertices, triangles, attributes, bounds. For
/// tables: rows and columns. Error(bad_input) for other files and for damaged files.
nlohmann::ordered_json describe_file(const std::filesystem::path& file);

}  // namespace vug::delivery
