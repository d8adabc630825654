#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/fit/json_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace vug::fit {

nlohmann::json read_json(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto until =
        text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), until, '\n');
    throw Error(ErrorCode::bad_input, "this is no JSON",
                {file.string(), static_cast<int>(line), 0});
  } catch (const nlohmann::json::exception&) {  // a number beyond all numbers
    throw Error(ErrorCode::bad_input, "this is no JSON that can be used", {file.string(), 0, 0});
  }
}

std::optional<int> whole_number(const nlohmann::json& value) {
  constexpr int64_t kMost = std::numeric_limits<int>::max();
  if (!value.is_number_integer()) return std::nullopt;
  if (value.is_number_unsigned() ? value.get<uint64_t>() > static_cast<uint64_t>(kMost)
                                 : value.get<int64_t>() < -kMost)
    return std::nullopt;
  return value.get<int>();
}

}  // namespace vug::fit
