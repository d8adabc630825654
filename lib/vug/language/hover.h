// SPDX-License-Identifier: Apache-2.0
// Hover: the description of the word at a position.
#pragma once

#include <vug/language/workspace.h>

#include <optional>
#include <string>

namespace vug::language {

struct Hover {
  SourceLocation range;
  std::string text;  ///< Markdown.
};

/// Nothing where the text has no meaning, such as a comment.
std::optional<Hover> hover_at(const Analysis& analysis, const Position& position);

}  // namespace vug::language
