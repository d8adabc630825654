// SPDX-License-Identifier: Apache-2.0
// Words that other programs use for a parameter.
#pragma once

#include <string>
#include <vector>

namespace vug {

/// The parameter that other programs call `name`, e.g. "spp" for "samples"; empty if none of the
/// candidates has that meaning.
std::string parameter_for(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace vug
