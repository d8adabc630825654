// SPDX-License-Identifier: Apache-2.0
// The meaning of each word of a text, for highlighting.
#pragma once

#include <vug/language/workspace.h>

#include <vector>

namespace vug::language {

enum class TokenMeaning {
  comment,
  text,
  number,
  keyword,
  sign,
  kind,      ///< A kind or a built-in function.
  function,  ///< A function of the text.
  argument,  ///< The name of an argument or the key of an entry.
  choice,    ///< A word that a parameter accepts.
  param,     ///< A `param` of the text.
  value,     ///< A let or a local name.
  declaration,
  symbol,  ///< A symbol of a grammar.
  module
};
/// The names of the meanings in the Language Server Protocol, in the order of the enumeration.
const std::vector<const char*>& meaning_names();

struct SemanticToken {
  SourceLocation where;  ///< On one line.
  TokenMeaning meaning = TokenMeaning::comment;
  bool declares = false;
};

/// The tokens in the order of the text, which do not overlap. Signs are omitted.
std::vector<SemanticToken> semantic_tokens(const Analysis& analysis);

}  // namespace vug::language
