// Limits of measures as people write them.
#pragma once

#include <vug/image/diff.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::cli {

/// "rmse=0.01" or "N.rmse=0.01". Error(bad_input) for anything else, for an unknown measure and for
/// one whose better values lie on the other side.
image::Limit parse_limit(const std::string& text, image::Measure::Better better);

/// The limits of a JSON object {"rmse": 0.01, "beauty.psnr": 40}; `where` names it in messages.
std::vector<image::Limit> limits_of(const nlohmann::ordered_json& object, const std::string& where);
std::vector<image::Limit> read_limits(const std::filesystem::path& file);

}  // namespace vug::cli
