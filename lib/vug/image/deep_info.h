// SPDX-License-Identifier: Apache-2.0
// Summary of a deep image file.
#pragma once

#include <vug/image/io.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace vug::image {

struct DeepInfo {
  FileInfo file;
  uint64_t samples = 0;  ///< Total over all pixels and views.
};

/// Reads the whole file; returns nothing for flat images. Throws the same errors as read_info.
std::optional<DeepInfo> read_deep_info(const std::filesystem::path& path);

}  // namespace vug::image
