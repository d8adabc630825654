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

/// Number of rows that are shown at either end of a long list.
constexpr size_t kEnds = 2;

/// Prints one "key: value" per line, with nested parts indented.
void print_lines(const Json& value, int depth) {
  const std::string indent(static_cast<size_t>(2 * depth), ' ');
  size_t row = 0;
  for (const auto& [key, part] : value.items()) {
    if (value.is_array() && value.size() > 4 * kEnds) {
      const size_t at = row++;
      if (at == kEnds)
        fmt::print("{}... {} more; --json prints all\n", indent, value.size() - 2 * kEnds);
      if (at >= kEnds && at + kEnds < value.size()) continue;
    }
    const std::string label = value.is_array() ? "-" : key + ":";
    const bool rows = part.is_object() || (part.is_array() && !part.empty() && part[0].is_object());
    if (rows) {
      fmt::print("{}{}\n", indent, label);
      print_lines(part, depth + 1);
    } else {
      const std::string text = part.is_string() ? part.get<std::string>() : dumped(part, -1);
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
