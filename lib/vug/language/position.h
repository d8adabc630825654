// SPDX-License-Identifier: Apache-2.0
// Positions between the characters of a text, and edits of it.
#pragma once

#include <vug/base/error.h>

#include <compare>
#include <string>
#include <string_view>
#include <vector>

namespace vug::language {

/// A position before a character; line and column count from 1, as in SourceLocation.
struct Position {
  int line = 1;
  int column = 1;
  auto operator<=>(const Position&) const = default;
};

inline Position begin_of(const SourceLocation& where) { return {where.line, where.column}; }
inline Position end_of(const SourceLocation& where) { return {where.end_line, where.end_column}; }
/// Whether the position is in the range or at one of its ends.
bool touches(const SourceLocation& where, const Position& position);
/// The empty range at a position.
SourceLocation range_at(const std::string& file, const Position& position);
/// The range between two positions of a file.
SourceLocation range_between(const std::string& file, const Position& begin, const Position& end);

/// The position before the character that contains a byte of a text with "\n" as line ends.
Position position_at(const std::string& text, size_t byte);

/// Where the unit of a number begins, in bytes: 2 in "30cm", the size without a unit.
size_t unit_begin(std::string_view number);

/// Replaces a range of a text; an empty range inserts.
struct TextEdit {
  SourceLocation range;
  std::string text;
  bool operator==(const TextEdit&) const = default;
};

/// The text after the edits, whose ranges refer to the text before and do not overlap. Their files
/// are ignored. Insertions at one position keep their order.
std::string apply(std::string text, std::vector<TextEdit> edits);

}  // namespace vug::language
