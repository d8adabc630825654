// SPDX-License-Identifier: Apache-2.0
// Parsing of the limits for image measures that `vug diff` and image tests take.
#pragma once

#include <vug/image/diff.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::cli {

/// Parses "rmse=0.01" or "N.rmse=0.01". Error(bad_input) for anything else, for an unknown measure
/// and for a measure that is better in the other direction.
image::Limit parse_limit(const std::string& text, image::Measure::Better better);

/// The limits of a JSON object {"rmse": 0.01, "beauty.psnr": 40}. Messages call it `where`.
std::vector<image::Limit> limits_of(const nlohmann::ordered_json& object, const std::string& where);
/// Reads such an object from a file.
std::vector<image::Limit> read_limits(const std::filesystem::path& file);

}  // namespace vug::cli
