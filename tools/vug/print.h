// Reports that are data, for people and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace vug::cli {

/// On stdout: one "key: value" a line with nested parts indented and texts cut to their first line,
/// or as JSON with whole texts.
void print_report(const nlohmann::ordered_json& report, bool json);

}  // namespace vug::cli
