// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/json_integer.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <limits>

namespace vug::fit {

std::optional<int> json_integer(const nlohmann::json& value) {
  constexpr int64_t kMax = std::numeric_limits<int>::max();
  if (!value.is_number_integer()) return std::nullopt;
  if (value.is_number_unsigned() ? value.get<uint64_t>() > static_cast<uint64_t>(kMax)
                                 : value.get<int64_t>() < -kMax)
    return std::nullopt;
  return value.get<int>();
}

}  // namespace vug::fit
