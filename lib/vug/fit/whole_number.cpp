#include <vug/fit/whole_number.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <limits>

namespace vug::fit {

std::optional<int> whole_number(const nlohmann::json& value) {
  constexpr int64_t kMost = std::numeric_limits<int>::max();
  if (!value.is_number_integer()) return std::nullopt;
  if (value.is_number_unsigned() ? value.get<uint64_t>() > static_cast<uint64_t>(kMost)
                                 : value.get<int64_t>() < -kMost)
    return std::nullopt;
  return value.get<int>();
}

}  // namespace vug::fit
