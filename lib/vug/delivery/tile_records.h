// SPDX-License-Identifier: Apache-2.0
// Internal to delivery. Records of the tiles that a run has written, from which an interrupted run
// continues.
#pragma once

#include <vug/base/hash.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::delivery {

/// What was written for a tile: `content`, which only the writer understands, and its files.
struct TileRecord {
  nlohmann::ordered_json content;
  std::vector<std::string> files;  ///< In the folder of the tiles.
};

/// The records of one volume, files .NAME.tile in the folder of its tiles.
class TileRecords {
 public:
  /// `key`: the digest of all that determines the bytes of the tiles.
  TileRecords(std::filesystem::path folder, const Digest& key);

  /// The record of a tile. Nothing if none was written with this key, or if a file of the tile is
  /// missing or has another size than it had then.
  std::optional<TileRecord> read(const std::string& name) const;
  /// Call it after the files of the tile are complete. Throws Error(io).
  void write(const std::string& name, const TileRecord& record) const;
  /// Call it before a file of the tile changes.
  void remove(const std::string& name) const;

 private:
  std::filesystem::path path_of(const std::string& name) const;

  std::filesystem::path folder_;
  std::string key_;
};

/// Removes the records of all volumes. Call it when the index is complete.
void remove_tile_records(const std::filesystem::path& folder);

}  // namespace vug::delivery
