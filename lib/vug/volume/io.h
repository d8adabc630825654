// SPDX-License-Identifier: Apache-2.0
// Reading and writing .vdb files. Files are written completely or not at all, with the same bytes
// for the same content.
#pragma once

#include <vug/volume/points.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace vug::volume {

struct WriteOptions {
  bool half = false;  ///< Store the floats of every grid as 16 bits, including grids that do not
                      ///< request it. Level sets get a band that 16 bits can represent.
  Metadata metadata;  ///< Added to every grid and to the file: recipe, seed, ...
};

/// Writes the grids in this order under their names through an AtomicFile, with blosc compression
/// (zlib if OpenVDB lacks blosc). Every grid gets vug:version, vug:metersPerUnit = 1 and vug:upAxis
/// = "y". The file's identifier, random in OpenVDB, becomes a hash of the bytes. Throws
/// Error(bad_input) for names that are empty or not unique, and for points together with other
/// grids, because many programs cannot read any grid of a file that contains points; Error(io).
void write(const std::filesystem::path& target, const std::vector<Grid>& grids,
           const WriteOptions& options = {});

struct ReadOptions {
  bool delayed = true;  ///< Leave voxel values on disk until their first use.
  bool verify = true;   ///< Verify the hash of files written by `write`.
};

/// Reads all grids of a .vdb file of any origin. Throws Error(bad_input) with the path if it is not
/// a .vdb file, or is truncated or damaged.
std::vector<Grid> read(const std::filesystem::path& source, const ReadOptions& options = {});
/// Reads one grid by name; an empty name selects the first level set, or else the first grid.
Grid read_grid(const std::filesystem::path& source, const std::string& name,
               const ReadOptions& options = {});

struct GridInfo {
  std::string name;
  GridClass grid_class = GridClass::unknown;
  std::string value_type;
  Vec3d voxel_size{0, 0, 0};
  bool half = false;
  Statistics statistics;
  Metadata metadata;
  std::optional<PointsInfo> points;  ///< Only for point grids.
};
struct FileInfo {
  uint64_t bytes = 0;
  uint32_t format_version = 0;
  std::string identifier;  ///< Hash of the content in files written by Vug, random in others.
  Metadata metadata;
  std::vector<GridInfo> grids;
};
FileInfo info(const std::filesystem::path& source);

}  // namespace vug::volume
