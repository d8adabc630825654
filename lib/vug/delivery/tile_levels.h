// SPDX-License-Identifier: Apache-2.0
// Internal to delivery. The files of the levels of detail of tiles, and their entries in the index.
#pragma once

#include <vug/base/progress.h>
#include <vug/exchange/usd_tiles.h>
#include <vug/shot/shot.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::delivery {

/// Writes levels for the tiles of the meshes of one shot.
class TileLevelFiles {
 public:
  /// `count`: the number of levels in addition to the full mesh. `usd_format`: "usda" or "usdc".
  TileLevelFiles(const shot::Shot& shot, std::filesystem::path folder, int count,
                 const std::string& usd_format)
      : shot_(shot), folder_(std::move(folder)), count_(count), usd_extension_("." + usd_format) {}

  int count() const { return count_; }

  /// Writes the levels of a tile: FILE_lodN with the extension of `file`, which contains the full
  /// mesh, and a USD layer for it and for each level. Adds `usd`, `levels` and `proxy` to the
  /// tile's entry, unless the mesh has no triangles. Returns the names of the written files.
  std::vector<std::string> write(const mesh::Mesh& mesh, const std::string& file,
                                 nlohmann::ordered_json& entry, Progress& progress) const;

  /// Writes the USD layer of a mesh that is not divided into tiles.
  exchange::UsdTile write_whole(const mesh::Mesh& mesh, const std::string& name) const;

 private:
  const shot::Shot& shot_;
  std::filesystem::path folder_;
  int count_;
  std::string usd_extension_;
};

/// The files that `write` has named in an entry.
std::vector<std::string> level_files(const nlohmann::ordered_json& entry);

/// Moves the proxy of an entry, which the index does not contain, to a tile of the layer of all
/// tiles with `count` levels in addition to the full one; missing levels are the coarsest existing
/// one. Nothing for an entry without levels.
std::optional<exchange::UsdTile> take_usd_tile(nlohmann::ordered_json& entry, int count);

/// A sentence about each level of a mesh with these tiles: its triangles and its distance.
std::vector<std::string> describe_levels(const std::string& mesh,
                                         const nlohmann::ordered_json& tiles);

}  // namespace vug::delivery
