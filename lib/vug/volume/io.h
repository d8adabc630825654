// .vdb files: written whole or not at all, with the same bytes for the same content.
#pragma once

#include <vug/volume/points.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace vug::volume {

struct WriteOptions {
  bool half = false;  ///< Store the floats of every grid as 16 bits, also of those that do not
                      ///< ask for it. Level sets get a band that 16 bits can hold.
  Metadata metadata;  ///< Added to every grid and to the file: recipe, seed, ...
};

/// Writes grids in this order under their names, through an AtomicFile, with blosc compression
/// (zlib where OpenVDB lacks it). Every grid gets vug:version, vug:metersPerUnit = 1 and
/// vug:upAxis = "y". The file's identifier, which OpenVDB draws at random, becomes a hash of the
/// bytes. Error(bad_input) for names that are empty or not unique, and for points beside other
/// grids: many programs can read nothing of a file that holds points; Error(io).
void write(const std::filesystem::path& target, const std::vector<Grid>& grids,
           const WriteOptions& options = {});

struct ReadOptions {
  bool delayed = true;  ///< Leave voxel values on disk until they are first read.
  bool verify = true;   ///< Compare the bytes of files that `write` made with their hash.
};

/// All grids of a .vdb file of any origin. Error(bad_input), naming the path, for what is not a
/// .vdb file, is cut off or damaged.
std::vector<Grid> read(const std::filesystem::path& source, const ReadOptions& options = {});
/// One grid by name; an empty name takes the first level set, else the first grid.
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
  std::optional<PointsInfo> points;  ///< Where it holds points.
};
struct FileInfo {
  uint64_t bytes = 0;
  uint32_t format_version = 0;
  std::string identifier;  ///< Hash of the content in files of ours, random in others.
  Metadata metadata;
  std::vector<GridInfo> grids;
};
FileInfo info(const std::filesystem::path& source);

}  // namespace vug::volume
