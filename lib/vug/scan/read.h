// Clouds out of files: PLY in any encoding, texts of numbers, and pictures that `vug render` made.
#pragma once

#include <vug/base/memory.h>
#include <vug/scan/point_cloud.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vug::scan {

struct ReadOptions {
  uint64_t memory = available_memory();  ///< Bytes that a file and its cloud may take together.
};

/// Of one file's bytes: PLY where they begin so, else a text. `file` is for messages. All functions
/// here throw Error(bad_input) with file, line and column for what is no cloud or an empty one, and
/// Error(too_large) before memory is taken. Points whose position is not finite are dropped and
/// counted.
PointCloud parse_cloud(std::string_view bytes, const std::string& file,
                       const ReadOptions& options = {});

/// All files as one cloud, in the given order; those called .exr are pictures.
PointCloud read_clouds(const std::vector<std::filesystem::path>& files,
                       const ReadOptions& options = {});

/// A point for each pixel of an EXR that shows a surface: its layer P, and N where there is one.
/// Error(bad_input) without P and Z.
PointCloud read_picture(const std::filesystem::path& path, const ReadOptions& options = {});

/// Vertices of a PLY file [@turk1994] with x, y, z and perhaps red, green, blue, intensity (also
/// called scalar_intensity, reflectance) and nx, ny, nz, in any order and type; all else is passed
/// over.
PointCloud parse_ply(std::string_view bytes, const std::string& file, const ReadOptions& options);

/// One point a line: x y z, perhaps then the intensity (4 numbers), red, green, blue (6), or both
/// (7). Numbers stand apart by blanks, commas or semicolons. Lines that begin with # or // are
/// comments; a first line without numbers is taken for a heading, one with a single whole number
/// for the count of points. Colours are 0..1, or 0..255 where one is above 1.
PointCloud parse_xyz(std::string_view bytes, const std::string& file, const ReadOptions& options);

}  // namespace vug::scan
