// SPDX-License-Identifier: Apache-2.0
// Parses the words of L-systems: modules with their arguments, branches and polygons.
#include <vug/scene/lsystem_parser.h>
#include <vug/scene/module_names.h>

#include <fmt/format.h>

namespace vug::scene {

namespace {

constexpr std::string_view kSigns = "+-&^\\/|$!'[]{}.%";

/// A sign that is a module; ".." is two modules.
bool is_module_sign(const Token& token) {
  if (token.kind != TokenKind::sign) return false;
  return token.text == ".." || token.is("?") ||
         (token.text.size() == 1 && kSigns.find(token.text[0]) != std::string_view::npos);
}

}  // namespace

bool starts_module(const Token& token) {
  return token.kind == TokenKind::name || is_module_sign(token);
}

bool is_turtle_name(const std::string& name) {
  return name == "F" || name == "f" || name == "G" ||
         (name.size() == 1 && kSigns.find(name[0]) != std::string_view::npos);
}

/// True at `where NAME =`, which cannot be modules.
bool LSystemParser::at_where(size_t from) const {
  return cursor_.peek(from).is_name("where") && cursor_.peek(from + 1).kind == TokenKind::name &&
         cursor_.peek(from + 2).is("=");
}

/// True if the word has another module: on this line, inside an open bracket or polygon, or on a
/// next line that starts with a sign or a capital letter and is not a rule.
bool LSystemParser::goes_on(bool open) const {
  const Token& here = cursor_.peek();
  if (at_where(0)) return false;
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
