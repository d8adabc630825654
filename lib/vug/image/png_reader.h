// SPDX-License-Identifier: Apache-2.0
// Internal to image/: reading of opaque PNG files with libpng.
#pragma once

#include <vug/image/io.h>

#include <filesystem>
#include <optional>

namespace vug::image {

/// See image::read, as stored in [0, 1], and image::read_info; the chunks have been verified. They
/// return nothing for files that are left to OpenImageIO: those that do not begin like a PNG, and
/// those with alpha, an offset, or data of a camera or of a photo editor.
std::optional<Image> read_plain_png(const std::filesystem::path& path);
std::optional<FileInfo> read_plain_png_info(const std::filesystem::path& path);

}  // namespace vug::image
