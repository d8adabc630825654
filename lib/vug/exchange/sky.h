// Inside exchange/ only: skies beside the files that name them.
#pragma once

#include <vug/exchange/light.h>

#include <filesystem>
#include <optional>
#include <string>

namespace vug::exchange {

/// Where a dome's picture lies: beside `file`, as FILE_NAME.exr; nothing for domes of one colour
/// and other lamps.
std::optional<std::filesystem::path> sky_file(const Light& light, const std::filesystem::path& file,
                                              const std::string& name);

/// Writes it there.
std::optional<std::filesystem::path> write_sky(const Light& light,
                                               const std::filesystem::path& file,
                                               const std::string& name);

}  // namespace vug::exchange
