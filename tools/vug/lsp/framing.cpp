// SPDX-License-Identifier: Apache-2.0
#include "lsp/framing.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <istream>
#include <ostream>

namespace vug::lsp {
namespace {

constexpr size_t kMaxLength = size_t{256} << 20;

/// The length in a line such as "Content-Length: 120"; nothing for other lines.
std::optional<size_t> length_in(std::string line) {
  const std::string name = "content-length:";
  if (line.size() < name.size()) return std::nullopt;
  for (size_t i = 0; i < name.size(); ++i)
    if (std::tolower(static_cast<unsigned char>(line[i])) != name[i]) return std::nullopt;
  const size_t begin = std::min(line.find_first_not_of(" \t", name.size()), line.size());
  size_t length = 0;
  const auto [end, failed] =
      std::from_chars(line.data() + begin, line.data() + line.size(), length);
  return failed == std::errc() && length <= kMaxLength ? std::optional(length) : std::nullopt;
}

}  // namespace

std::optional<std::string> read_message(std::istream& in) {
  std::optional<size_t> length;
  std::string line;
  bool any = false;
  while (std::getline(in, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() && any) break;
    any = any || !line.empty();
    if (const auto found = length_in(line)) length = found;
  }
  if (!any) return std::nullopt;
  std::string content(length.value_or(0), '\0');
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (static_cast<size_t>(in.gcount()) != content.size()) return std::nullopt;
  return content;
}

void write_message(std::ostream& out, const std::string& content) {
  out << "Content-Length: " << content.size() << "\r\n\r\n" << content << std::flush;
}

}  // namespace vug::lsp
