// SPDX-License-Identifier: Apache-2.0
// Printing of structured reports, for people and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace vug::cli {

/// Prints a report to stdout: as one "key: value" per line with nested parts indented and strings
/// cut to their first line, or as JSON with complete strings.
void print_report(const nlohmann::ordered_json& report, bool json);

}  // namespace vug::cli
