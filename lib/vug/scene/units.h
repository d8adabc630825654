// SPDX-License-Identifier: Apache-2.0
// Units of numbers in scene texts.
#pragma once

#include <vug/base/value.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vug::scene {

/// `value` with `unit` as a Number in the internal unit of its dimension or as a fraction; nothing
/// for a unit that is not in the table of units.cpp.
std::optional<Number> with_unit(double value, std::string_view unit);

/// Names of all units except %, for suggestions and reserved names.
const std::vector<std::string>& unit_names();
bool is_unit(std::string_view name);

}  // namespace vug::scene
