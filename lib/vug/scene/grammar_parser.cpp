// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/grammar_parser.h>
#include <vug/scene/lsystem_parser.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::scene {

namespace {

bool is_item_sign(const Token& token) {
  return token.is("+") || token.is("-") || token.is("&") || token.is("~");
}

/// Clause keywords, which may start a line and are never a shape after "~ NAME".
constexpr const char* kClauseWords[] = {"label", "blend"};

/// The other clauses of loading/item_clauses.cpp, which may also be names of shapes; a test of that
/// module compares the lists.
constexpr const char* kOtherClauses[] = {"overlap", "reach",  "pieces", "piece_label", "slope",
                                         "azimuth", "within", "apart",  "name",        "connect"};

bool is_clause_word(const Token& token) {
  return std::any_of(std::begin(kClauseWords), std::end(kClauseWords),
                     [&](const char* word) { return token.is_name(word); });
}

bool is_clause_name(const Token& token) {
  return is_clause_word(token) ||
         std::any_of(std::begin(kOtherClauses), std::end(kOtherClauses),
                     [&](const char* word) { return token.is_name(word); });
}

/// Whether a clause with its value starts here: "~ rock name "hall"", but not "~ MP name label +X".
bool at_clause(const Cursor& cursor) {
  if (is_clause_word(cursor.peek())) return true;
  const Token& value = cursor.peek(1);
  return is_clause_name(cursor.peek()) && ExprParser::starts(value) && !is_clause_name(value) &&
         !(value.is("(") && value.touches) &&
         !((value.is("+") || value.is("-")) && !cursor.peek(2).touches);
}

std::vector<std::string> listed(const std::set<std::string>& names) {
  return {names.begin(), names.end()};
}

}  // namespace

void GrammarParser::parse(Grammar& grammar, RuleLookahead& lookahead) {
  const int faults = cursor_.faults();
  grammar.broken = true;  // until it is parsed
  if (cursor_.accept(":")) {
    const Token& kind = cursor_.expect_name("the kind of grammar after ':'");
    grammar.kind = std::string(kind.text);
    const std::vector<std::string> kinds = {"shape", "lsystem", "facade"};
    if (std::find(kinds.begin(), kinds.end(), grammar.kind) == kinds.end())
      cursor_.fail(kind, fmt::format("unknown kind of grammar '{}'", kind.text),
                   suggestion(grammar.kind, kinds));
  }
  if (!cursor_.accept_beyond_newlines("{")) cursor_.unexpected("'{' before the grammar's rules");
  if (grammar.kind == "lsystem") return LSystemParser(cursor_, lookahead).parse(grammar);
  places_ = grammar.kind == "facade";
  const Token& open = cursor_.last();
  find_heads();
  for (;;) {
    while (cursor_.peek().kind == TokenKind::newline) cursor_.take();
    if (cursor_.accept("}")) {
      grammar.broken = cursor_.faults() != faults;
      return;
    }
    if (cursor_.at_end() || cursor_.at_statement()) {
      cursor_.error(open, fmt::format("the '{{' of grammar '{}' is never closed", grammar.name));
      return;
    }
    const Token& first = cursor_.peek();
    const bool is_rule = at_rule() || find_assignment(cursor_);
    try {
      entry(grammar);
      if (!cursor_.at_line_end()) cursor_.unexpected("the end of the line");
    } catch (const SyntaxFault&) {
      cursor_.recover_entry();
      while (is_rule && is_where(cursor_.beyond_newlines())) {
        cursor_.skip_newlines();
        cursor_.take();
        cursor_.recover_entry();
      }
      if (is_rule) grammar.broken_rules.emplace(first.text);
    }
  }
}

void GrammarParser::entry(Grammar& grammar) {
  if (at_rule()) {
    grammar.rules.push_back(rule());
    return;
  }
  if (!cursor_.peek().is_name("axiom")) {
    reject_assignment(cursor_);
    grammar.options.push_back(parse_entry(cursor_, exprs_));
    return;
  }
  const Token& word = cursor_.take();
  if (grammar.axiom_where.known())
    cursor_.error(word, fmt::format("grammar '{}' has two axioms", grammar.name));
  grammar.axiom_where = cursor_.where(word);
  grammar.axiom = items("the axiom");
}

bool GrammarParser::at_rule(size_t from) const {
  if (cursor_.peek(from).kind != TokenKind::name) return false;
  int depth = 0;
  for (size_t ahead = from + 1;; ++ahead) {
    const Token& token = cursor_.peek(ahead);
    if (token.is("->")) return true;
    if (token.kind == TokenKind::end || token.is("{") || token.is("}")) return false;
    if (token.is("(") || token.is("[")) ++depth;
    if (token.is(")") || token.is("]")) --depth;
    // The arrow may be the first token of the next line.
    if (token.kind == TokenKind::newline && depth <= 0)
      return cursor_.peek(beyond_newlines(ahead)).is("->");
  }
}

size_t GrammarParser::beyond_newlines(size_t ahead) const {
  while (cursor_.peek(ahead).kind == TokenKind::newline && cursor_.peek(ahead).text != ";") ++ahead;
  return ahead;
}

void GrammarParser::find_heads() {
  heads_.clear();
  Cursor scout = cursor_;
  bool start = true, goes_on = false;  // the last sign of a line may continue its locals
  while (!scout.at_end() && !scout.peek().is("}") && !scout.at_statement()) {
    const Token& token = scout.peek();
    if (start && !goes_on && token.kind == TokenKind::name) {
      const GrammarParser reader(scout);
      if (reader.at_rule() || find_assignment(scout)) heads_.insert(std::string(token.text));
    }
    start = token.kind == TokenKind::newline;
    if (!start) goes_on = token.is(",") || token.is("=");
    scout.take();
  }
}

Rule GrammarParser::rule() {
  Rule rule;
  const Token& head = cursor_.take();
  rule.head = std::string(head.text);
  rule.where = cursor_.where(head);
  if (cursor_.peek().is("(")) rule.formals = formals();
  if (cursor_.accept("@")) rule.weight = exprs_.whole();
  if (cursor_.peek().is_name("if")) {
    cursor_.take();
    rule.guard = exprs_.whole();
  }
  if (!cursor_.accept_beyond_newlines("->"))
    cursor_.unexpected(rule.guard || rule.weight ? "'->'" : "'->', '@ weight' or 'if condition'");
  if (!at_rule(beyond_newlines(0))) cursor_.skip_newlines();
  if (cursor_.peek().is_name("nothing") && !heads_.count("nothing"))
    cursor_.take();
  else
    rule.items = items(fmt::format("the rule of '{}'", rule.head));
  rule.locals = locals();
  rule.extent = cursor_.since(head);
  return rule;
}

/// Whether the names of a rule follow. A symbol may be called 'where' as well.
bool GrammarParser::is_where(const Token& token) const {
  return token.is_name("where") && !heads_.count("where");
}

std::vector<Let> GrammarParser::locals() {
  return is_where(cursor_.beyond_newlines()) ? exprs_.locals() : std::vector<Let>{};
}

std::vector<Formal> GrammarParser::formals() {
  std::vector<Formal> formals;
  cursor_.take();
  const Cursor::BracketScope brackets(cursor_);
  while (!cursor_.peek().is(")")) {
    const Token& name = cursor_.expect_name("the name of a parameter");
    formals.push_back({std::string(name.text), cursor_.where(name)});
    if (!cursor_.accept(",")) break;
  }
  cursor_.expect(")", " after the rule's parameters");
  return formals;
}

/// True if the right-hand side has another item, on this line or on the next one. A continuation
/// line starts with an operation or with a symbol that does not start a rule.
bool GrammarParser::continues() const {
  const Token& token = cursor_.peek();
  if (is_where(token)) return false;
  if (token.kind != TokenKind::newline) return !cursor_.at_line_end();
  const size_t next = beyond_newlines(0);
  const Token& first = cursor_.peek(next);
  const bool symbol = first.kind == TokenKind::name && heads_.count(std::string(first.text));
  return is_item_sign(first) || (symbol && !at_rule(next) && !find_assignment(cursor_, next));
}

std::vector<Item> GrammarParser::items(const std::string& whose) {
  std::vector<Item> items;
  while (continues()) {
    if (items.empty() && at_rule(beyond_newlines(0))) break;
    cursor_.skip_newlines();
    const Token& next = cursor_.peek(1);
    if (next.is("->") || next.is("@") || next.is_name("if"))
      cursor_.fail(cursor_.peek(), "a second rule on one line",
                   "put ';' or a line break before it");
    const Token& first = cursor_.peek();
    items.push_back(item());
    items.back().where = cursor_.since(first);
  }
  if (items.empty())
    cursor_.fail(cursor_.last(), fmt::format("{} has no items", whose),
                 cursor_.last().is("->") ? "write 'nothing' for a symbol that vanishes" : "");
  return items;
}

Item GrammarParser::item() {
  Item item;
  const Token& first = cursor_.peek();
  if (places_) {
    if (first.kind != TokenKind::name) cursor_.unexpected("a symbol, a split or an element");
    item.shape = exprs_.shape();
    return item;
  }
  if (is_item_sign(first)) {
    item.op = std::string(cursor_.take().text);
    if (!at_rule(beyond_newlines(0))) cursor_.skip_newlines();
    if (item.op == "~") morph_amount(item);
    if (!item.shape) item.shape = exprs_.shape();
  } else {
    if (first.kind != TokenKind::name) cursor_.unexpected("a symbol or one of + - & ~");
    item.shape = exprs_.shape();
    const bool symbol = item.shape->kind == ExprKind::name ||
                        (item.shape->kind == ExprKind::call && !item.shape->method);
    if (!symbol)
      cursor_.error(item.shape->extent, "a shape without an operation",
                    "write + - & or ~ before it");
    else if (!heads_.count(item.shape->text))
      cursor_.error(first, fmt::format("no rule for the symbol '{}'", item.shape->text),
                    item.shape->kind == ExprKind::call
                        ? "a shape needs one of + - & ~ before it"
                        : suggestion(item.shape->text, listed(heads_)));
  }
  if (cursor_.accept("*")) item.count = exprs_.tight();
  clauses(item);
  return item;
}

/// After "~", a number, a range or brackets are the amount. A name is the amount if a shape follows
/// it; `~ rock label +X` has no amount.
void GrammarParser::morph_amount(Item& item) {
  const Token& first = cursor_.peek();
  const Token& second = cursor_.peek(1);
  const bool call = second.is("(") && second.touches;
  if (first.kind == TokenKind::name && (call || second.is("."))) return;
  const ExprPtr value = exprs_.tight();
  const Token& next = cursor_.peek();
  const bool shape_follows =
      next.is("(") || (next.kind == TokenKind::name && !at_clause(cursor_) &&
                       !(value->kind == ExprKind::name && heads_.count(std::string(next.text))));
  if (value->kind == ExprKind::name && !shape_follows)
    item.shape = value;
  else
    item.amount = value;
}

void GrammarParser::clauses(Item& item) {
  for (;;) {
    if (cursor_.peek().kind == TokenKind::newline && is_clause_word(cursor_.beyond_newlines()))
      cursor_.skip_newlines();
    const Token& key = cursor_.peek();
    if (key.kind != TokenKind::name || heads_.count(std::string(key.text)) || is_where(key)) return;
    if (cursor_.peek(1).is("(") && cursor_.peek(1).touches) return;  // an unknown symbol
    cursor_.take();
    const Token& value = cursor_.peek();
    const bool sign = (value.is("+") || value.is("-")) && !cursor_.peek(1).touches;
    const bool symbol = value.kind == TokenKind::name && heads_.count(std::string(value.text));
    if (!ExprParser::starts(value) || sign || symbol) {
      if (is_clause_name(key)) cursor_.fail(key, fmt::format("'{}' has no value", key.text));
      std::vector<std::string> known(std::begin(kClauseWords), std::end(kClauseWords));
      known.insert(known.end(), std::begin(kOtherClauses), std::end(kOtherClauses));
      known.insert(known.end(), heads_.begin(), heads_.end());
      cursor_.fail(
          key,
          fmt::format("'{}' is neither a symbol with a rule nor a clause with a value", key.text),
          suggestion(std::string(key.text), known));
    }
    Entry clause;
    clause.key = std::string(key.text);
    clause.where = cursor_.where(key);
    clause.values.push_back(exprs_.tight());
    clause.extent = cursor_.since(key);
    item.clauses.push_back(std::move(clause));
  }
}

const Token* find_assignment(const Cursor& cursor, size_t from) {
  const Token& first = cursor.peek(from);
  if (first.kind != TokenKind::name || first.is_name("where")) return nullptr;
  int depth = 0;
  for (size_t ahead = from + 1;; ++ahead) {
    const Token& token = cursor.peek(ahead);
    const bool ends = token.kind == TokenKind::newline || token.is("{") || token.is("}");
    if (token.kind == TokenKind::end || token.is("->") || (depth == 0 && ends)) return nullptr;
    if (token.is("(") || token.is("[")) ++depth;
    if (token.is(")") || token.is("]")) --depth;
    if (depth == 0 && token.is("=")) return &token;
  }
}

void reject_assignment(Cursor& cursor) {
  const Token& name = cursor.peek();
  if (const Token* sign = find_assignment(cursor))
    cursor.fail(
        *sign, fmt::format("expected '->' or a value after '{}', found '='", name.text),
        fmt::format("write a rule as '{0} -> ...' and an option as '{0} VALUE'", name.text));
}

Entry parse_entry(Cursor& cursor, ExprParser& exprs) {
  Entry entry;
  const Token& key = cursor.expect_name("a name");
  entry.key = std::string(key.text);
  while (cursor.accept(".")) entry.key += fmt::format(".{}", cursor.expect_name("a name").text);
  entry.where = cursor.since(key);
  const Token& next = cursor.peek();
  if (next.is("=") || next.is(":"))
    cursor.fail(next, fmt::format("expected the value of '{}', found '{}'", key.text, next.text),
                fmt::format("write the value right after the name: {} ...", key.text));
  if (cursor.at_line_end()) {
    cursor.error(key, fmt::format("'{}' has no value", key.text),
                 "write the value after the name, on the same line");
    throw SyntaxFault{};
  }
  entry.values.push_back(exprs.whole());
  while (cursor.accept_beyond_newlines(",")) {
    cursor.skip_newlines();
    entry.values.push_back(exprs.whole());
  }
  entry.extent = cursor.since(key);
  return entry;
}

}  // namespace vug::scene
