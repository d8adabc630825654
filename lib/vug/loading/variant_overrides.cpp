// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/variant_overrides.h>
#include <vug/scene/text_at.h>

#include <algorithm>

namespace vug::loading {
namespace {

/// The text without comments, with spaces as line breaks.
std::string on_one_line(std::string_view text) {
  std::string out;
  bool quoted = false, comment = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') comment = false;
    if (c == '#' && !quoted) comment = true;
    if (comment) continue;
    if (c == '"') quoted = !quoted;
    out += c == '\n' ? ' ' : c;
    if (quoted && c == '\\' && i + 1 < text.size()) out += text[++i];
  }
  const size_t begin = std::min(out.find_first_not_of(' '), out.size());
  return out.substr(begin, out.find_last_not_of(' ') + 1 - begin);
}

/// The text of the entry's value.
std::string value_text(const scene::Entry& entry, const scene::Document& document) {
  for (const auto& source : document.sources)
    if (source->file == entry.extent.file)
      return on_one_line(scene::text_at(source->text, entry.extent).substr(entry.key.size()));
  return {};
}

}  // namespace

std::vector<scene::Override> variant_overrides(const scene::Document& document,
                                               const std::string& variant,
                                               const std::vector<scene::Override>& given) {
  const scene::Declaration* chosen = document.find(variant, "variant");
  if (variant.empty() || !chosen) return {};
  std::vector<scene::Override> all;
  for (const scene::Entry& entry : chosen->entries) {
    const bool is_set = std::any_of(given.begin(), given.end(), [&](const scene::Override& each) {
      return each.name == entry.key;
    });
    if (!is_set) all.push_back({entry.key, value_text(entry, document)});
  }
  return all;
}

}  // namespace vug::loading
