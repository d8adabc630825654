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
constexpr std::string_view kSigns = "+-&^\\/|$!'[]{}.%";

/// A sign that is a module; ".." is two modules.
bool is_module_sign(const Token& token) {
  if (token.kind != TokenKind::sign) return false;
  return token.text == ".." || token.is("?") ||
         (token.text.size() == 1 && kSigns.find(token.text[0]) != std::string_view::npos);
}

bool starts_module(const Token& token) {
  return token.kind == TokenKind::name || is_module_sign(token);
}

/// Keywords after a rule's head.
bool is_production_clause(const Token& token) {
  return token.is_name("if") || token.is_name("after");
}

}  // namespace

bool is_turtle_name(const std::string& name) {
  return name == "F" || name == "f" || name == "G" ||
         (name.size() == 1 && kSigns.find(name[0]) != std::string_view::npos);
}

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

/// True if the word has another module: on this line, inside an open bracket or polygon, or on a
/// next line that starts with a sign or a capital letter and is not a rule.
bool LSystemParser::goes_on(bool open) const {
  const Token& here = cursor_.peek();
  if (here.kind != TokenKind::newline) return here.is("}") ? open : !cursor_.at_line_end();
  if (here.text == ";") return false;
  const size_t next = lookahead_.beyond_newlines(0);
  const Token& first = cursor_.peek(next);
  if (first.is("}")) return false;  // a leading '}' closes the block
  if (!starts_module(first) || at_rule(next)) return false;
  return open || first.kind == TokenKind::sign || is_capital(first.text[0]);
}

ModuleString LSystemParser::word(const std::string& whose) {
  ModuleString word;
  std::vector<const Token*> branches, polygons;
  while (goes_on(!polygons.empty() || !branches.empty())) {
    const bool next_line = cursor_.peek().kind == TokenKind::newline;
    while (cursor_.peek().kind == TokenKind::newline) cursor_.take();
    const Token& token = cursor_.peek();
    if (token.is("}") && polygons.empty()) break;
    if (next_line && token.column <= indent_ && branches.empty() && polygons.empty())
      cursor_.fail(token, "a line without '->'",
                   fmt::format("write rules as: head -> successor; a line with a deeper indent "
                               "continues {}",
                               whose));
    if (token.is("->"))
      cursor_.fail(token, "a second rule on one line", "put ';' or a line break before it");
    if (!starts_module(token)) {
      std::string hint;
      if (token.kind == TokenKind::number)
        hint = "a module's name begins with a letter; write numbers in ( )";
      if (token.is("<") || token.is(">")) hint = "write contexts before the arrow";
      cursor_.fail(token, fmt::format("expected a module, found {}", describe(token)), hint);
    }
    if (token.is("[")) branches.push_back(&token);
    if (token.is("{")) polygons.push_back(&token);
    if (token.is("]") || token.is("}")) {
      std::vector<const Token*>& open = token.is("]") ? branches : polygons;
      if (open.empty())
        cursor_.fail(token, fmt::format("'{}' without a matching '{}' in {}", token.text,
                                        token.is("]") ? "[" : "{", whose));
      open.pop_back();
    }
    module(word);
  }
  for (const auto& stack : {branches, polygons})
    if (!stack.empty())
      cursor_.fail(*stack.back(),
                   fmt::format("the '{}' in {} is never closed", stack.back()->text, whose));
  if (word.empty())
    cursor_.fail(cursor_.last(), fmt::format("{} has no modules", whose),
                 cursor_.last().is("->") ? "write 'nothing' for a module that vanishes" : "");
  return word;
}

/// Parses the modules of one token: consecutive letters are several modules, and the last one takes
/// the arguments.
void LSystemParser::module(ModuleString& word) {
  const Token& token = cursor_.take();
  SourceLocation where = cursor_.where(token);
  const auto add = [&](std::string_view name) {
    where = word_at(where, std::string(name));
    word.push_back({std::string(name), where, {}});
    where.column = where.end_column;
  };
  if (token.kind == TokenKind::name) {
    for (const std::string_view name : split_names(token.text)) add(name);
  } else if (token.is("..")) {
    add("."), add(".");
  } else if (token.is("?")) {
    const Token& name = cursor_.expect_name("the name of a query after '?'");
    word.push_back({fmt::format("?{}", name.text), cursor_.since(token), {}});
  } else {
    add(token.text);
  }
  if (!cursor_.peek().is("(")) return;
  if (token.is("[") || token.is("]") || token.is("{") || token.is("}") || token.is("%"))
    cursor_.fail(cursor_.peek(), fmt::format("'{}' takes no parameters", token.text));
  word.back().arguments = arguments(word.back());
  word.back().where = word.back().where.up_to(cursor_.where(cursor_.last()));
}

std::vector<ExprPtr> LSystemParser::arguments(const Module& whose) {
  std::vector<ExprPtr> out;
  const Token& open = cursor_.take();
  const Cursor::BracketScope brackets(cursor_);
  while (!cursor_.peek().is(")")) {
    out.push_back(exprs_.whole());
    if (cursor_.peek().is(":"))
      cursor_.fail(cursor_.peek(), "modules take their arguments by position");
    if (!cursor_.accept(",")) break;
  }
  cursor_.expect(")", fmt::format(" to close '{}(' of line {}", whose.name, open.line));
  return out;
}

}  // namespace vug::scene
