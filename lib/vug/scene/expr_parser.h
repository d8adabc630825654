// SPDX-License-Identifier: Apache-2.0
// Parser of expressions, also in binding_parser.cpp and by_rock_parser.cpp; the EBNF is in
// docs/reference/language.md.
#pragma once

#include <vug/scene/cursor.h>

#include <map>
#include <string>

namespace vug::scene {

class ExprParser {
 public:
  explicit ExprParser(Cursor& cursor) : cursor_(cursor) {}

  /// A full expression; it continues across a line break before an operator or a ".method".
  ExprPtr whole();
  /// An expression whose only operators outside brackets are signs, powers and a range. Used where
  /// + - & * have another meaning (counts, amounts and clauses of items).
  ExprPtr tight();
  /// A name, call or bracketed expression with its method chain: the shape of an item.
  ExprPtr shape();
  /// `[NAMES in LIST if CONDITION]` after the name of a declaration, as a comprehension whose
  /// elements are the lists of the variables.
  ExprPtr declared_loop();
  /// `name = default "text", ...` up to ")", which is consumed.
  std::vector<Formal> formals();
  /// `where name = value, ...`, here or on the next line; empty if there is no `where`.
  std::vector<Let> locals();
  /// `lo..hi` as its two ends.
  void bounds(ExprPtr& low, ExprPtr& high);

  /// True at a token that can start an expression.
  static bool starts(const Token& token);

 private:
  ExprPtr binary(int least);
  ExprPtr prefix();
  ExprPtr postfix();
  ExprPtr primary();
  ExprPtr bracketed();
  ExprPtr list();
  ExprPtr comprehension(const Token& open);
  void loop_clauses(Expr& comprehension);
  void bound_names(Operand& clause);
  void loop_clause(Operand clause, const Token& first, Expr& comprehension);
  ExprPtr index(ExprPtr base, const Token& first);
  ExprPtr call(const Token& name, ExprPtr receiver, const Token& first);
  void operand(Expr& call, bool& named);
  ExprPtr by_rock(const Token& by);
  const Token& operator_ahead() const;

  ExprPtr finish(Expr expr, const Token& first);
  uint64_t identity(const std::string& path);
  void restart();

  Cursor& cursor_;
  std::string path_;                      ///< Names of the enclosing calls and arguments.
  std::map<std::string, uint64_t> seen_;  ///< Number of previous occurrences of each path.
};

}  // namespace vug::scene
