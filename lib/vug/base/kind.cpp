// SPDX-License-Identifier: Apache-2.0
#include <vug/base/kind.h>

#include <fmt/format.h>

namespace vug::detail {

Arguments as_arguments(const NamedValues& parameters) {
  Arguments arguments;
  for (const auto& [name, value] : parameters) arguments.push_back({name, value, {}});
  return arguments;
}

void refuse_unknown(const std::string& type, const std::string& name,
                    const std::vector<std::string>& known) {
  throw Error(ErrorCode::bad_input, fmt::format("unknown {} '{}'", type, name), {},
              suggestion(name, known));
}

void refuse(const Diagnostics& diagnostics) {
  std::string message, hint;
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.severity != Severity::error) continue;
    if (message.empty()) hint = d.hint;
    message += (message.empty() ? "" : "; ") + d.message;
  }
  throw Error(ErrorCode::bad_input, message, {}, hint);
}

}  // namespace vug::detail
