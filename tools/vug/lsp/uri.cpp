// SPDX-License-Identifier: Apache-2.0
#include "lsp/uri.h"

#include <fmt/format.h>

#include <cctype>

namespace vug::lsp {
namespace {

constexpr std::string_view kScheme = "file://";

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int letter = std::tolower(static_cast<unsigned char>(c)) - 'a';
  return letter >= 0 && letter < 6 ? 10 + letter : -1;
}

}  // namespace

std::filesystem::path path_of(const std::string& uri) {
  if (!uri.starts_with(kScheme)) return uri;
  const size_t slash = uri.find('/', kScheme.size());  // after the name of a host
  if (slash == std::string::npos) return uri;
  std::string path;
  for (size_t i = slash; i < uri.size(); ++i) {
    const bool code =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    if (code) {
      path += static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
      i += 2;
    } else {
      path += uri[i];
    }
  }
  if (path.find('\0') != std::string::npos) return uri;
  return std::filesystem::path(path).lexically_normal();
}

std::string uri_of(const std::filesystem::path& path) {
  const std::string text = path.generic_string();
  if (!text.starts_with('/')) return text;
  std::string uri(kScheme);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte < 0x80 && std::isalnum(byte)) ||
                       std::string_view("/-._~").find(c) != std::string_view::npos;
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return uri;
}

}  // namespace vug::lsp
