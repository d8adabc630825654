// SPDX-License-Identifier: Apache-2.0
// Counting and checking of UTF-8 characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vug {

/// True for bytes that continue a character.
constexpr bool is_utf8_tail(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Number of bytes of the first character: 1 to 4; 0 if the text does not start with a well-formed
/// one.
size_t utf8_length(std::string_view text);

/// Number of characters; stray bytes that continue a character do not count.
int utf8_count(std::string_view text);

/// True if every byte belongs to a well-formed character.
bool is_utf8(std::string_view text);

/// True if more than a tenth of the text's beginning consists of control characters and ill-formed
/// bytes.
bool is_binary(std::string_view text);

/// The text with ill-formed bytes and control characters (except tabs) replaced by U+FFFD.
std::string printable(std::string_view text);

}  // namespace vug
