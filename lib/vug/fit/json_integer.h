// Numbers in JSON that users hand in.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace vug::fit {

/// The value where it is a whole number that an int can hold.
std::optional<int> json_integer(const nlohmann::json& value);

}  // namespace vug::fit
