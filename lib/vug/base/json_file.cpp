// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/json_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace vug {

SourceLocation location_in(const std::string& text, const std::string& file, size_t at) {
  const auto until = text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size()));
  const auto line = 1 + std::count(text.begin(), until, '\n');
  const size_t newline = text.rfind('\n', at == 0 ? 0 : at - 1);
  const bool first = newline == std::string::npos || newline >= at;
  return {file, static_cast<int>(line), static_cast<int>(first ? at + 1 : at - newline)};
}

template <class Json>
Json read_json(const std::filesystem::path& file, const std::string& hint) {
  const std::string text = read_text(file);
  try {
    return Json::parse(text);
  } catch (const typename Json::parse_error& error) {
    throw Error(ErrorCode::bad_input, "invalid JSON",
                location_in(text, file.string(), std::max<size_t>(error.byte, 1) - 1), hint);
  } catch (const typename Json::exception&) {  // a number out of range
    throw Error(ErrorCode::bad_input, "invalid JSON: a number is out of range",
                {file.string(), 0, 0}, hint);
  }
}

template nlohmann::json read_json(const std::filesystem::path&, const std::string&);
template nlohmann::ordered_json read_json(const std::filesystem::path&, const std::string&);

}  // namespace vug
