// SPDX-License-Identifier: Apache-2.0
// USD as text: a layer that can be written without a library.
#include <vug/exchange/usd_writer.h>

namespace vug::exchange {
namespace {

/// Reads the lines `string "vug:NAME" = "..."` before the first prim.
std::vector<std::pair<std::string, std::string>> read_usda(std::string_view bytes,
                                                           const std::string& file) {
  if (bytes.substr(0, 5) != "#usda")
    throw Error(ErrorCode::bad_input, "the file is not a USD text", {file, 1, 1});
  const bool whole = bytes.size() >= 3 && bytes.substr(bytes.size() - 3) == "\n}\n";
  bytes = bytes.substr(0, bytes.find("\ndef "));
  constexpr std::string_view kBegin = "string \"vug:", kEquals = "\" = \"";
  std::vector<std::pair<std::string, std::string>> texts;
  for (size_t at = bytes.find(kBegin); at != std::string_view::npos; at = bytes.find(kBegin, at)) {
    at += kBegin.size();
    const size_t end = bytes.find(kEquals, at);
    if (end == std::string_view::npos) break;
    const std::string name = "vug:" + std::string(bytes.substr(at, end - at));
    std::string text;
    for (at = end + kEquals.size(); at < bytes.size() && bytes[at] != '"'; ++at) {
      const bool escape = bytes[at] == '\\' && at + 1 < bytes.size();
      const char c = bytes[escape ? ++at : at];
      text += !escape ? c : c == 'n' ? '\n' : c == 'r' ? '\r' : c == 't' ? '\t' : c;
    }
    texts.emplace_back(name, std::move(text));
  }
  if (!texts.empty() && !whole)
    throw Error(ErrorCode::bad_input, "the file is truncated: its last prim is not closed",
                {file, 0, 0});
  return texts;
}

}  // namespace
}  // namespace vug::exchange

VUG_EXCHANGE_FORMAT(usda) {
  return {{"usda",
           "exchange format",
           "USD as text: meshes with primvars and preview surfaces, instances, volumes, cameras "
           "and lights of any shape",
           "usd",
           {}},
          std::nullopt,
          true,
          write_usd_assembly,
          read_usda,
          true};
}
