// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: reads the provenance from a crate file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::exchange {

/// The texts of `customLayerData` whose names begin with "vug:"; empty for files of other programs
/// and for versions before 0.4.0. Throws Error(bad_input) for a file that is damaged or truncated.
std::vector<std::pair<std::string, std::string>> read_crate_metadata(std::string_view bytes,
                                                                     const std::string& file);

}  // namespace vug::exchange
