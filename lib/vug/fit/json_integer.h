// SPDX-License-Identifier: Apache-2.0
// Validated integers from user-supplied JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace vug::fit {

/// The value if it is an integer that fits an int.
std::optional<int> json_integer(const nlohmann::json& value);

}  // namespace vug::fit
