// SPDX-License-Identifier: Apache-2.0
// The source of the texts that a scene includes.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace vug::scene {

/// Reads a file; returns nothing if it does not exist.
using FileReader = std::function<std::optional<std::string>(const std::filesystem::path&)>;

}  // namespace vug::scene
