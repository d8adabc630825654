// SPDX-License-Identifier: Apache-2.0
#include <vug/language/kinds.h>
#include <vug/language/semantic_tokens.h>
#include <vug/language/words.h>
#include <vug/scene/functions.h>

#include <map>

namespace vug::language {
namespace {

using scene::Token;
using scene::TokenKind;

TokenMeaning meaning_of(const Symbol& symbol) {
  switch (symbol.kind) {
    case SymbolKind::param:
      return TokenMeaning::param;
    case SymbolKind::function:
      return TokenMeaning::function;
    case SymbolKind::declaration:
    case SymbolKind::grammar:
      return TokenMeaning::declaration;
    case SymbolKind::rule:
    case SymbolKind::table:
      return TokenMeaning::symbol;
    case SymbolKind::module:
      return TokenMeaning::module;
    default:
      return TokenMeaning::value;
  }
}

/// The meaning of a name that is not one of the text.
TokenMeaning meaning_of_word(const std::vector<Token>& tokens, size_t index) {
  const Token& token = tokens[index];
  const Token& next = tokens[index + 1];
  const std::string word(token.text);
  const bool first = index == 0 || tokens[index - 1].kind == TokenKind::newline ||
                     tokens[index - 1].kind == TokenKind::comment;
  if (first && token.column == 1 && (find_word(statement_words(), word) || find_declaration(word)))
    return TokenMeaning::keyword;
  if (next.is(":")) return TokenMeaning::argument;
  if (next.is("(") && next.touches) {
    if (word == "if" || word == "pick" || word == "keys") return TokenMeaning::keyword;
    return TokenMeaning::kind;
  }
  if (find_word(inner_words(), word) || word == "true" || word == "false")
    return TokenMeaning::keyword;
  const bool before_value = next.kind == TokenKind::name || next.kind == TokenKind::number ||
                            next.kind == TokenKind::text || next.kind == TokenKind::size ||
                            ((next.is("(") || next.is("[")) && !next.touches);
  if (before_value) return TokenMeaning::argument;
  if (!callable_kinds(word).empty()) return TokenMeaning::kind;
  return TokenMeaning::choice;
}

}  // namespace

const std::vector<const char*>& meaning_names() {
  static const std::vector<const char*> names = {
      "comment",  "string",     "number",    "keyword",  "operator", "type",  "function",
      "property", "enumMember", "parameter", "variable", "class",    "macro", "namespace"};
  return names;
}

std::vector<SemanticToken> semantic_tokens(const Analysis& analysis) {
  std::map<Position, const Reference*> references;
  for (const Reference& each : analysis.symbols.references)
    if (each.where.file == analysis.file) references.emplace(begin_of(each.where), &each);
  std::vector<SemanticToken> all;
  const std::vector<Token>& tokens = analysis.tokens;
  const auto add = [&](const SourceLocation& where, TokenMeaning meaning, bool declares = false) {
    if (where.line == where.end_line) all.push_back({where, meaning, declares});
  };
  for (size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    const SourceLocation where{analysis.file, token.line, token.column, token.end_line(),
                               token.end_column()};
    switch (token.kind) {
      case TokenKind::comment:
        add(where, TokenMeaning::comment);
        break;
      case TokenKind::text:
        add(where, TokenMeaning::text);
        break;
      case TokenKind::number:
      case TokenKind::size:
        add(where, TokenMeaning::number);
        break;
      case TokenKind::name: {
        // A row of letters in an L-system is several names, some of which have no rule.
        SourceLocation rest = where;
        for (auto at = references.lower_bound(begin_of(where));
             at != references.end() && at->first < end_of(where); ++at) {
          const SourceLocation& name = at->second->where;
          if (rest.column < name.column)
            add({analysis.file, rest.line, rest.column, rest.line, name.column},
                TokenMeaning::symbol);
          add(name, meaning_of(analysis.symbols.of(*at->second)), at->second->declares);
          rest.column = name.end_column;
        }
        if (rest == where)
          add(where, meaning_of_word(tokens, i));
        else if (rest.column < rest.end_column)
          add(rest, TokenMeaning::symbol);
        break;
      }
      default:
        break;
    }
  }
  return all;
}

}  // namespace vug::language
