// SPDX-License-Identifier: Apache-2.0
#include "lsp/text_index.h"

#include <vug/base/utf8.h>
#include <vug/scene/text_at.h>

#include <algorithm>

namespace vug::lsp {
namespace {

/// Code units of the character that begins with this byte. Bytes that begin no character count like
/// one that continues the last: not at all, as in columns of a scene.
int units_of(char first, Encoding encoding) {
  const auto byte = static_cast<unsigned char>(first);
  if (encoding == Encoding::utf8) return 1;
  if (is_utf8_tail(first)) return 0;
  return byte >= 0xf0 ? 2 : 1;
}

}  // namespace

TextIndex::TextIndex(std::string text, Encoding encoding)
    : text_(std::move(text)), starts_{0}, encoding_(encoding) {
  for (size_t at = 0; at < text_.size(); ++at)
    if (text_[at] == '\n') starts_.push_back(at + 1);
}

std::string_view TextIndex::line(int number) const {
  const size_t begin = starts_[static_cast<size_t>(number)];
  const bool last = number + 1 == lines();
  const size_t end = last ? text_.size() : starts_[static_cast<size_t>(number) + 1] - 1;
  return std::string_view(text_).substr(begin, end - begin);
}

int TextIndex::units(std::string_view text) const {
  int count = 0;
  for (const char c : text) count += units_of(c, encoding_);
  return count;
}

ClientPosition TextIndex::to_client(const language::Position& position) const {
  const int number = std::clamp(position.line - 1, 0, lines() - 1);
  if (position.line - 1 > number) return {number, units(line(number))};
  const std::string_view whole = line(number);
  return {number, units(whole.substr(0, scene::byte_at(whole, 1, position.column)))};
}

language::Position TextIndex::from_client(const ClientPosition& position) const {
  const int number = std::clamp(position.line, 0, lines() - 1);
  const std::string_view whole = line(number);
  const int wanted = position.line > number ? units(whole) : std::max(position.character, 0);
  int column = 1, passed = 0;
  for (size_t at = 0; at < whole.size() && passed < wanted; ++column) {
    size_t next = at + 1;
    while (next < whole.size() && is_utf8_tail(whole[next])) ++next;
    passed += units(whole.substr(at, next - at));
    at = next;
  }
  return {number + 1, column};
}

}  // namespace vug::lsp
