// SPDX-License-Identifier: Apache-2.0
// Internal to image/: reading of flat EXR files with OpenEXR.
#pragma once

#include <vug/image/io.h>

#include <filesystem>
#include <optional>

namespace vug::image::exr {

/// See image::read and image::read_info, which have verified the headers. They return nothing for
/// files that are left to OpenImageIO: those that do not begin like an EXR, deep ones, and those
/// with integers or subsampled channels.
std::optional<Image> read_flat(const std::filesystem::path& path);
std::optional<FileInfo> read_flat_info(const std::filesystem::path& path);

}  // namespace vug::image::exr
