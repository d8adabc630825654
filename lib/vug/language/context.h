// SPDX-License-Identifier: Apache-2.0
// The place in a text where something is being written, found from its tokens, so that it is known
// in statements with syntax errors, too.
#pragma once

#include <vug/language/workspace.h>

#include <set>
#include <string>
#include <vector>

namespace vug::language {

/// The kind of text that a position expects.
enum class Place {
  nothing,       ///< A comment or a text in quotes.
  path,          ///< The path of an include.
  statement,     ///< The first word of a statement.
  new_name,      ///< The name that a statement declares.
  grammar_kind,  ///< After "grammar NAME:".
  key,           ///< The key of an entry of a block, or the head of a rule.
  value,         ///< An expression.
  symbols,       ///< The right-hand side of a rule, or an axiom.
  member,        ///< After a "."
  unit,          ///< Directly after a number.
  after_value    ///< After a complete value on the same line.
};

/// A call whose brackets are open at the position.
struct OpenCall {
  std::string name;
  std::string receiver;  ///< The name before ".name(", if it is one.
  bool method = false;
  size_t position = 0;          ///< Index of the current argument, counting the receiver.
  size_t unnamed = 0;           ///< Number of arguments by position before it, with the receiver.
  std::string argument;         ///< The name before ":" of the current argument; may be empty.
  std::set<std::string> given;  ///< Names of arguments, also of those after the position.
  bool begins = false;          ///< Nothing of the current argument has been written.
};

struct Context {
  Place place = Place::nothing;
  SourceLocation range;         ///< The whole name or number at the position, or an empty range.
  std::string keyword;          ///< First word of the statement; empty before it.
  std::string name;             ///< The name that the statement declares.
  std::string grammar;          ///< Kind of a grammar: "shape", "facade", "lsystem"; else empty.
  bool target = false;          ///< After `on`.
  bool in_block = false;        ///< Inside "{" of the statement.
  std::string key;              ///< The current entry of the block.
  std::set<std::string> keys;   ///< Other entries of the block before the position.
  std::string kind;             ///< The value of its entry `kind`.
  std::vector<OpenCall> calls;  ///< From the outermost to the innermost.
  /// Inside brackets of a list or a vector in the innermost call, or in the entry.
  bool in_list = false;
  bool in_vector = false;
  std::string receiver;          ///< With Place::member: the name before the "."; may be empty.
  std::set<std::string> locals;  ///< Names that the statement binds before the position.

  const OpenCall* call() const { return calls.empty() ? nullptr : &calls.back(); }
};

Context context_at(const Analysis& analysis, const Position& position);

/// The index of the token that contains or ends at the position, the later one of two; -1: none.
int token_at(const std::vector<scene::Token>& tokens, const Position& position);

}  // namespace vug::language
