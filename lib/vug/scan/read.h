// SPDX-License-Identifier: Apache-2.0
// Readers of point clouds: PLY in any encoding, text files of numbers, and pictures made by `vug
// render`.
#pragma once

#include <vug/base/memory.h>
#include <vug/scan/point_cloud.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vug::scan {

struct ReadOptions {
  /// Memory limit in bytes for a file and its cloud together.
  uint64_t memory = available_memory();
};

/// Parses the bytes of one file: PLY if they start with its signature, otherwise text. `file` is
/// used in messages. All functions here throw Error(bad_input) with file, line and column for
/// invalid or empty clouds, and Error(too_large) before memory is allocated. Points with a
/// non-finite position are dropped and counted.
PointCloud parse_cloud(std::string_view bytes, const std::string& file,
                       const ReadOptions& options = {});

/// All files as one cloud, in the given order; .exr files are read as pictures.
PointCloud read_clouds(const std::vector<std::filesystem::path>& files,
                       const ReadOptions& options = {});

/// One point for each pixel of an EXR that shows a surface, from the layers P and Z and, if
/// present, N. Error(bad_input) without P and Z.
PointCloud read_picture(const std::filesystem::path& path, const ReadOptions& options = {});

/// Vertices of a PLY file [@turk1994] with x, y, z and optionally red, green, blue, intensity (also
/// scalar_intensity, reflectance) and nx, ny, nz, in any order and of any type; everything else is
/// ignored.
PointCloud parse_ply(std::string_view bytes, const std::string& file, const ReadOptions& options);

/// One point per line: x y z, optionally followed by the intensity (4 numbers), by red, green, blue
/// (6), or by both (7). Numbers are separated by blanks, commas or semicolons. Lines that begin
/// with # or // are comments; a first line without numbers is a header, one with a single integer a
/// point count. Colours are 0..1, or 0..255 if one of them exceeds 1.
PointCloud parse_xyz(std::string_view bytes, const std::string& file, const ReadOptions& options);

}  // namespace vug::scan
