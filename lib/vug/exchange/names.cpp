// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/names.h>

#include <fmt/format.h>

namespace vug::exchange {

std::string identifier(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    out += plain ? c : '_';
  }
  const bool begins = !out.empty() && !(out[0] >= '0' && out[0] <= '9');
  return begins ? out : fmt::format("_{}", out);
}

std::string UniqueNames::unique(const std::string& text) {
  const std::string base = identifier(text);
  std::string name = base;
  for (int number = 2; !used_.insert(name).second; ++number)
    name = fmt::format("{}_{}", base, number);
  return name;
}

}  // namespace vug::exchange
