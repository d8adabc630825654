// The block of an L-system out of tokens: the dialect of `grammar NAME: lsystem { ... }`.
#pragma once

#include <vug/scene/expr_parser.h>
#include <vug/scene/lsystem_document.h>
#include <vug/scene/rule_lookahead.h>

namespace vug::scene {

class LSystemParser {
 public:
  /// `lookahead` is one for all blocks of a file, of the same cursor.
  LSystemParser(Cursor& cursor, RuleLookahead& lookahead)
      : cursor_(cursor), exprs_(cursor), lookahead_(lookahead) {}

  /// Everything behind the block's '{' up to its '}'; broken parts are reported and left out.
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

  bool at_rule(size_t from = 0) const;
  bool at_part() const;
  bool at_lost_brace() const;

  Cursor& cursor_;
  ExprParser exprs_;
  RuleLookahead& lookahead_;
  LSystem* system_ = nullptr;
  int indent_ = 0;  ///< Column that the rule or the axiom begins at; 0 behind others on its line.
};

/// The names that letters in a row are: each capital begins one, so FFA is F F A and FlFr is Fl Fr;
/// and Ff is F f, the turtle's line and its move, as ff is f f. The pieces view the text.
std::vector<std::string_view> split_names(std::string_view letters);

}  // namespace vug::scene
