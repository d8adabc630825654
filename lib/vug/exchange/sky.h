// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: environment maps next to the files that refer to them.
#pragma once

#include <vug/exchange/light.h>

#include <filesystem>
#include <optional>
#include <string>

namespace vug::exchange {

/// The path of a dome's environment map: next to `file`, as FILE_NAME.exr; nothing for constant
/// domes and other lights.
std::optional<std::filesystem::path> sky_file(const Light& light, const std::filesystem::path& file,
                                              const std::string& name);

/// Writes the environment map to that path.
std::optional<std::filesystem::path> write_sky(const Light& light,
                                               const std::filesystem::path& file,
                                               const std::string& name);

}  // namespace vug::exchange
