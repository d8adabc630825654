// SPDX-License-Identifier: Apache-2.0
#include "print.h"

#include <fmt/format.h>
#include <vug/base/utf8.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The value as JSON. Strings from other programs' files may hold arbitrary bytes.
std::string dumped(const Json& value, int indent) {
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// Vectors as in scenes, so that they can be copied; strings as they are; else JSON.
std::string value_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  const bool vector = value.is_array() && value.size() == 3 && value[0].is_number() &&
                      value[1].is_number() && value[2].is_number();
  if (!vector) return dumped(value, -1);
  return fmt::format("({}, {}, {})", value[0].dump(), value[1].dump(), value[2].dump());
}

/// The longest list that is shown as a whole, and the number of its first rows if it is longer:
/// reports begin lists with the most important rows.
constexpr size_t kLongest = 8;
constexpr size_t kFirst = 4;

/// Prints one "key: value" per line, with nested parts indented.
void print_lines(const Json& value, int depth) {
  const std::string indent(static_cast<size_t>(2 * depth), ' ');
  size_t row = 0;
  for (const auto& [key, part] : value.items()) {
    if (value.is_array() && value.size() > kLongest && row++ == kFirst) {
      fmt::print("{}... {} more; --json prints all\n", indent, value.size() - kFirst);
      return;
    }
    const std::string label = value.is_array() ? "-" : key + ":";
    const bool rows = part.is_object() || (part.is_array() && !part.empty() && part[0].is_object());
    if (rows) {
      fmt::print("{}{}\n", indent, label);
      print_lines(part, depth + 1);
    } else {
      const std::string text = value_text(part);
      const size_t line = text.find('\n');
      fmt::print("{}{} {}{}\n", indent, label, printable(text.substr(0, line)),
                 line == std::string::npos ? "" : " ...");
    }
  }
}

}  // namespace

void print_report(const Json& report, bool json) {
  if (json)
    fmt::print("{}\n", dumped(report, 2));
  else
    print_lines(report, 0);
}

}  // namespace vug::cli
