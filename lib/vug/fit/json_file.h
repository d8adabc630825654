// JSON that users hand in.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace vug::fit {

/// Error(bad_input) with the line where the file is no JSON, or cannot be read.
nlohmann::json read_json(const std::filesystem::path& file);

}  // namespace vug::fit
