// SPDX-License-Identifier: Apache-2.0
// Reading of JSON files provided by users.
#pragma once

#include <vug/base/error.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace vug {

/// The line and column (in bytes) of the byte with index `at` in a file's text.
SourceLocation location_in(const std::string& text, const std::string& file, size_t at);

/// The file's JSON as nlohmann::json or ordered_json. Throws Error(bad_input) with the location and
/// the hint if the file cannot be read or is not valid JSON.
template <class Json>
Json read_json(const std::filesystem::path& file, const std::string& hint = {});

}  // namespace vug
