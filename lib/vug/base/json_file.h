// JSON that users hand in.
#pragma once

#include <vug/base/error.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace vug {

/// The line and column, in bytes, of byte `at` of a file's text.
SourceLocation place_in(const std::string& text, const std::string& file, size_t at);

/// The file's JSON, as nlohmann::json or ordered_json. Error(bad_input) with its place and that
/// hint where it is none, or cannot be read.
template <class Json>
Json read_json(const std::filesystem::path& file, const std::string& hint = {});

}  // namespace vug
