// The little that columns and carets need to know of UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vug::scene {

/// True for bytes that continue a character.
constexpr bool is_utf8_tail(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Bytes of the first character: 1 to 4; 0 when the text does not start with a well-formed one.
size_t utf8_length(std::string_view text);

/// True when every byte belongs to a well-formed character.
bool is_utf8(std::string_view text);

/// True when control characters and ill-formed bytes are more than a tenth of how the text starts.
bool is_binary(std::string_view text);

/// The text with ill-formed bytes and control characters (but tabs) shown as U+FFFD.
std::string printable(std::string_view text);

}  // namespace vug::scene
