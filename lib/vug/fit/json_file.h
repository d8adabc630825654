// JSON that users hand in.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>

namespace vug::fit {

/// Error(bad_input) with the line where the file is no JSON, or cannot be read.
nlohmann::json read_json(const std::filesystem::path& file);

/// The value where it is a whole number that an int can hold.
std::optional<int> whole_number(const nlohmann::json& value);

}  // namespace vug::fit
