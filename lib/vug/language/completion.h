// SPDX-License-Identifier: Apache-2.0
// Completion: the texts that can be written at a position.
#pragma once

#include <vug/language/context.h>

#include <string>
#include <vector>

namespace vug::language {

enum class CompletionKind {
  keyword,
  argument,  ///< The name of a parameter, with ":" or a space.
  choice,
  kind,      ///< A kind or a built-in function.
  function,  ///< A function of the text.
  value,     ///< A param, a let or a local name.
  declaration,
  symbol,  ///< A symbol of a grammar.
  module,
  unit,
  file
};

struct Completion {
  std::string label;
  CompletionKind kind = CompletionKind::keyword;
  std::string detail;  ///< A line, such as a type.
  std::string doc;     ///< Markdown.
  /// Replaces the range; "${1:radius}" is a field to fill in, "$0" the position of the cursor
  /// afterwards, and "\\$" a dollar.
  std::string snippet;
  int rank = 0;  ///< Smaller ones come first.
};

struct Completions {
  SourceLocation range;  ///< The text that is replaced.
  std::vector<Completion> items;
};

/// All completions of the place, whatever part of a word has been written there.
Completions complete(const Workspace& workspace, const Analysis& analysis,
                     const Position& position);

}  // namespace vug::language
