// SPDX-License-Identifier: Apache-2.0
// Parser of grammar blocks of shapes and facades; for L-systems see lsystem_parser.h.
#pragma once

#include <vug/scene/expr_parser.h>
#include <vug/scene/rule_lookahead.h>

#include <set>
#include <string>

namespace vug::scene {

class GrammarParser {
 public:
  explicit GrammarParser(Cursor& cursor) : cursor_(cursor), exprs_(cursor) {}

  /// Parses everything after the grammar's name into `grammar`. All grammars of a file share one
  /// `lookahead`.
  void parse(Grammar& grammar, RuleLookahead& lookahead);

 private:
  void entry(Grammar& grammar);
  Rule rule();
  std::vector<Formal> formals();
  std::vector<Let> locals();
  bool is_where(const Token& token) const;
  std::vector<Item> items(const std::string& whose);
  Item item();
  void morph_amount(Item& item);
  void clauses(Item& item);
  bool continues() const;
  bool at_rule(size_t from = 0) const;
  size_t beyond_newlines(size_t ahead) const;
  void find_heads();

  Cursor& cursor_;
  ExprParser exprs_;
  std::set<std::string> heads_;  ///< Symbols with a rule in this block.
  bool places_ = false;          ///< A facade: items are only symbols and calls.
};

/// The "=" in a line of a grammar that begins with a name, the token `from` positions ahead, but is
/// not a rule; null if there is none.
const Token* find_assignment(const Cursor& cursor, size_t from = 0);

/// Fails at an "=" in a line of a grammar that begins with a name but is not a rule.
void reject_assignment(Cursor& cursor);

/// Parses `key value, value ...`; the cursor is at the key.
Entry parse_entry(Cursor& cursor, ExprParser& exprs);

}  // namespace vug::scene
