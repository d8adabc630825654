// SPDX-License-Identifier: Apache-2.0
// Parser of L-system blocks: the dialect of `grammar NAME: lsystem { ... }`.
#pragma once

#include <vug/scene/expr_parser.h>
#include <vug/scene/lsystem_document.h>
#include <vug/scene/rule_lookahead.h>

namespace vug::scene {

/// Whether a module can begin with the token: a name or one of the turtle's signs.
bool starts_module(const Token& token);

class LSystemParser {
 public:
  /// All blocks of a file share one `lookahead` of the same cursor.
  LSystemParser(Cursor& cursor, RuleLookahead& lookahead)
      : cursor_(cursor), exprs_(cursor), lookahead_(lookahead) {}

  /// Parses everything after the block's '{' up to its '}'; erroneous parts are reported and
  /// omitted.
  void parse(Grammar& grammar);

 private:
  using Block = std::vector<Production>;

  void entries(const std::string& what, Block& rules, Grammar* grammar, ExprPtr* depth);
  void entry(Block& rules, Grammar* grammar, ExprPtr* depth);
  void part(Grammar& grammar);
  void table();
  void stage(ProductionStage& stage);
  void schedule();
  void names(std::vector<Pattern>& out);

  Production production();
  void sides(Production& production);
  std::vector<Pattern> patterns();
  void pattern(std::vector<Pattern>& out);
  ModuleString word(const std::string& whose);
  void module(ModuleString& word);
  std::vector<ExprPtr> arguments(const Module& whose);
  bool goes_on(bool open) const;
  bool at_where(size_t from) const;

  bool at_rule(size_t from = 0) const;
  bool at_part() const;
  bool at_lost_brace() const;

  Cursor& cursor_;
  ExprParser exprs_;
  RuleLookahead& lookahead_;
  LSystem* system_ = nullptr;
  int indent_ = 0;  ///< Start column of the rule or axiom; 0 if it is not the first on its line.
};

}  // namespace vug::scene
