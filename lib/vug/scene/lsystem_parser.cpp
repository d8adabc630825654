// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/grammar_parser.h>
#include <vug/scene/lsystem_parser.h>
#include <vug/scene/module_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace vug::scene {

namespace {

constexpr const char* kHeads = "write heads as: left < strict > right";

/// Keywords after a rule's head.
bool is_production_clause(const Token& token) {
  return token.is_name("if") || token.is_name("after");
}

}  // namespace

void LSystemParser::parse(Grammar& grammar) {
  auto system = std::make_shared<LSystem>();
  system_ = system.get();
  grammar.lsystem = system;
  const int faults = cursor_.faults();
  grammar.broken = true;  // until it is parsed
  entries(fmt::format("grammar '{}'", grammar.name), system->productions, &grammar, nullptr);
  grammar.broken = cursor_.faults() != faults;
}

void LSystemParser::entries(const std::string& what, Block& rules, Grammar* grammar,
                            ExprPtr* depth) {
  const Token& open = cursor_.last();
  for (;;) {
    while (cursor_.peek().kind == TokenKind::newline) cursor_.take();
    if (cursor_.accept("}")) return;
    if (cursor_.at_end() || at_lost_brace()) {
      cursor_.error(open, fmt::format("the '{{' of {} is never closed", what));
      return;
    }
    const size_t start = cursor_.position();
    try {
      entry(rules, grammar, depth);
      if (!cursor_.at_line_end()) cursor_.unexpected("the end of the line");
    } catch (const SyntaxFault&) {
      cursor_.recover_entry();
      if (cursor_.position() == start) cursor_.take();  // a line that looks like a statement
    }
  }
}

void LSystemParser::entry(Block& rules, Grammar* grammar, ExprPtr* depth) {
  const Token& first = cursor_.peek();
  const Token& before = cursor_.last();
  indent_ = before.kind == TokenKind::newline && before.text != ";" ? first.column : 0;
  if (grammar && at_part()) return part(*grammar);
  if (at_rule()) {
    rules.push_back(production());
    return;
  }
  if (first.kind != TokenKind::name || (!grammar && !first.is_name("depth")))
    cursor_.fail(first, fmt::format("expected a rule, found {}", describe(first)),
                 "write rules as: head -> successor");
  const Cursor::LineScope line(cursor_);
  reject_assignment(cursor_);
  if (grammar) {
    grammar->options.push_back(parse_entry(cursor_, exprs_));
    const Token& next = cursor_.peek();
    if (!cursor_.at_line_end() && starts_module(next))
      cursor_.fail(next, fmt::format("expected the end of the line, found {}", describe(next)),
                   fmt::format("separate the values of '{}' by commas", first.text));
  } else if (depth) {
    cursor_.take();
    *depth = exprs_.whole();
  } else {
    cursor_.fail(first, "a table can only contain rules");
  }
}

/// True at a keyword that starts a part of the block that is neither a rule nor an option.
bool LSystemParser::at_part() const {
  const Token& first = cursor_.peek();
  const Token& second = cursor_.peek(1);
  if (first.is_name("table"))
    return second.kind == TokenKind::name && cursor_.peek(lookahead_.beyond_newlines(2)).is("{");
  if (first.is_name("decompose") || first.is_name("interpret"))
    return second.is("{") || (second.kind == TokenKind::newline && !at_rule());
  const bool list = first.is_name("axiom") || first.is_name("ignore") ||
                    first.is_name("consider") || first.is_name("ages") || first.is_name("schedule");
  return list && !at_rule();
}

void LSystemParser::part(Grammar& grammar) {
  const Token& word = cursor_.take();
  if (word.is_name("axiom")) {
    if (grammar.axiom_where.known())
      cursor_.error(word, fmt::format("grammar '{}' has two axioms", grammar.name));
    grammar.axiom_where = cursor_.where(word);
    system_->axiom = this->word("the axiom");
  } else if (word.is_name("table")) {
    table();
  } else if (word.is_name("decompose")) {
    stage(system_->decompose);
  } else if (word.is_name("interpret")) {
    stage(system_->interpret);
  } else if (word.is_name("schedule")) {
    schedule();
  } else {
    names(word.is_name("ignore")     ? system_->ignore
          : word.is_name("consider") ? system_->consider
                                     : system_->ages);
  }
}

void LSystemParser::table() {
  const Token& word = cursor_.last();
  const Token& name = cursor_.expect_name("the name of the table");
  ProductionTable table{std::string(name.text), cursor_.where(name), {}, {}};
  for (const ProductionTable& other : system_->tables)
    if (other.name == table.name)
      cursor_.error(name, fmt::format("duplicate table '{}'", table.name),
                    fmt::format("the first is at {}", to_string(other.where)));
  if (!cursor_.accept_beyond_newlines("{")) cursor_.unexpected("'{' before the table's rules");
  entries(fmt::format("table '{}'", table.name), table.productions, nullptr, nullptr);
  table.extent = cursor_.since(word);
  system_->tables.push_back(std::move(table));
}

void LSystemParser::stage(ProductionStage& stage) {
  const Token& word = cursor_.last();
  if (stage.where.known())
    cursor_.error(word, fmt::format("duplicate '{}' block", word.text),
                  fmt::format("the first is at {}", to_string(stage.where)));
  stage.where = cursor_.where(word);
  if (!cursor_.accept_beyond_newlines("{"))
    cursor_.unexpected(fmt::format("'{{' after '{}'", word.text));
  entries(fmt::format("'{}'", word.text), stage.productions, nullptr, &stage.depth);
  stage.extent = cursor_.since(word);
}

void LSystemParser::schedule() {
  const Token& word = cursor_.last();
  const Cursor::LineScope line(cursor_);
  while (!cursor_.at_line_end()) {
    const Token& name = cursor_.expect_name("the name of a table");
    ScheduleTurn turn{std::string(name.text), cursor_.where(name), nullptr};
    if (cursor_.accept("*")) turn.count = exprs_.tight();
    system_->schedule.push_back(std::move(turn));
    cursor_.accept(",");
  }
  if (system_->schedule.empty())
    cursor_.fail(word, "'schedule' needs at least one table", "schedule spring*3 summer*2");
}

void LSystemParser::names(std::vector<Pattern>& out) {
  const Token& word = cursor_.last();
  while (!cursor_.at_line_end()) {
    pattern(out);
    cursor_.accept(",");
    if (!out.back().formals.empty())
      cursor_.error(out.back().where, fmt::format("'{}' can only list names", word.text));
  }
  if (out.empty())
    cursor_.fail(word, fmt::format("'{}' has no names", word.text),
                 fmt::format("{} + - F", word.text));
}

/// True if the line contains an arrow outside brackets, or the next line starts with one.
bool LSystemParser::at_rule(size_t from) const {
  return starts_module(cursor_.peek(from)) && lookahead_.arrow_ahead(from);
}

/// True at a token that can only start a statement of the scene. A line of modules may look like
/// one, `A B {`, but no statement starts with a capital letter or with a keyword of this dialect.
bool LSystemParser::at_lost_brace() const {
  return cursor_.at_statement() && !is_capital(cursor_.peek().text[0]) && !at_part() && !at_rule();
}

Production LSystemParser::production() {
  Production production;
  const Token& first = cursor_.peek();
  sides(production);
  for (;;) {
    const Token& clause = cursor_.peek();
    ExprPtr* slot = clause.is("@")            ? &production.weight
                    : clause.is_name("if")    ? &production.guard
                    : clause.is_name("after") ? &production.after
                                              : nullptr;
    if (!slot) break;
    if (*slot) cursor_.fail(clause, fmt::format("duplicate '{}' in a rule", clause.text));
    cursor_.take();
    *slot = exprs_.whole();
  }
  if (!cursor_.accept_beyond_newlines("->"))
    cursor_.unexpected("'->', '@ weight', 'if condition' or 'after age'");
  if (!at_rule(lookahead_.beyond_newlines(0))) cursor_.skip_newlines();
  if (cursor_.peek().is_name("nothing"))
    cursor_.take();
  else
    production.word = word(fmt::format("the rule of '{}'", production.head.name));
  if (at_where(lookahead_.beyond_newlines(0))) {
    const Cursor::LineScope line(cursor_);
    cursor_.skip_newlines();
    production.locals = exprs_.locals();
  }
  production.extent = cursor_.since(first);
  return production;
}

/// Parses `left < head > right`.
void LSystemParser::sides(Production& production) {
  const Token& first = cursor_.peek();
  std::vector<Pattern> head = patterns();
  if (cursor_.accept("<")) {
    production.left = std::move(head);
    for (const Pattern& one : production.left)
      if (one.name == "[" || one.name == "]")
        cursor_.error(first, "a left context cannot have branches",
                      "it follows the path to the root and skips side branches");
    head = patterns();
  }
  if (cursor_.accept(">")) {
    production.right = patterns();
    if (production.right.empty())
      cursor_.fail(cursor_.last(), "expected a right context after '>'", kHeads);
  }
  if (cursor_.peek().is("<") || cursor_.peek().is(">"))
    cursor_.fail(cursor_.peek(),
                 fmt::format("duplicate '{}' in the head of a rule", cursor_.peek().text), kHeads);
  if (head.size() != 1)
    cursor_.fail(first,
                 head.empty() ? "a rule without a module to replace"
                              : fmt::format("a rule replaces one module, not {}", head.size()),
                 "the modules around it are its context: left < strict > right");
  production.head = std::move(head[0]);
  for (const char* fixed : {"[", "]", "%"})
    if (production.head.name == fixed)
      cursor_.error(production.head.where, fmt::format("'{}' cannot be replaced", fixed));
  int open = 0;
  for (const Pattern& one : production.right) {
    open += one.name == "[" ? 1 : one.name == "]" ? -1 : 0;
    if (open < 0) break;
    if (open > cursor_.options().max_nesting)
      cursor_.fail(first, fmt::format("more than {} levels of nesting", open - 1));
  }
  if (open != 0) cursor_.error(first, "unbalanced brackets in the right context");
}

std::vector<Pattern> LSystemParser::patterns() {
  std::vector<Pattern> out;
  while (starts_module(cursor_.peek()) && !is_production_clause(cursor_.peek())) pattern(out);
  return out;
}

void LSystemParser::pattern(std::vector<Pattern>& out) {
  ModuleString modules;
  module(modules);
  for (Module& one : modules) {
    Pattern& made = out.emplace_back(Pattern{std::move(one.name), std::move(one.where), {}});
    for (const ExprPtr& argument : one.arguments) {
      if (argument->kind != ExprKind::name)
        cursor_.fail(
            cursor_.last(),
            fmt::format("the parameters of '{}' in a rule's head must be names", made.name),
            fmt::format("write {0}(x) if x == ...", made.name));
      made.formals.push_back({argument->text, argument->where});
    }
  }
}

}  // namespace vug::scene
