// What is in a file with a deep picture.
#pragma once

#include <vug/image/io.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace vug::image {

struct DeepInfo {
  FileInfo file;
  uint64_t samples = 0;  ///< Of all pixels and views together.
};

/// Reads all of the file; nothing where its picture is flat. Errors as read_info.
std::optional<DeepInfo> read_deep_info(const std::filesystem::path& path);

}  // namespace vug::image
