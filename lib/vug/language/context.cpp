// SPDX-License-Identifier: Apache-2.0
#include <vug/language/context_scanner.h>

namespace vug::language {
namespace {

using scene::Token;
using scene::TokenKind;

Position start_of(const Token& token) { return {token.line, token.column}; }
Position stop_of(const Token& token) { return {token.end_line(), token.end_column()}; }

/// The place inside a comment or a text in quotes.
Context inside_words(const Token& token, const Token* before, const std::string& file,
                     const Position& position) {
  Context context;
  context.range = range_at(file, position);
  if (token.kind != TokenKind::text || !before || !before->is_name("include")) return context;
  context.place = Place::path;
  const bool closed = token.text.size() > 1 && token.text.back() == '"';
  context.range = range_between(file, {token.line, token.column + 1},
                                {token.line, token.end_column() - (closed ? 1 : 0)});
  return context;
}

}  // namespace

int token_at(const std::vector<Token>& tokens, const Position& position) {
  int found = -1;
  for (size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (position < start_of(token)) break;
    if (token.kind == TokenKind::end || token.kind == TokenKind::newline) continue;
    if (position <= stop_of(token)) found = static_cast<int>(i);
  }
  return found;
}

Context context_at(const Analysis& analysis, const Position& position) {
  const std::vector<Token>& all = analysis.tokens;
  std::vector<Token> tokens;  // without comments
  tokens.reserve(all.size());
  for (const Token& token : all) {
    if (token.kind != TokenKind::comment) {
      tokens.push_back(token);
    } else if (start_of(token) < position && position <= stop_of(token)) {
      return inside_words(token, nullptr, analysis.file, position);
    }
  }
  ContextScanner scanner(tokens);
  size_t at = 0;
  for (; at < tokens.size(); ++at) {
    const Token& token = tokens[at];
    if (token.kind == TokenKind::end || position <= start_of(token)) break;
    const bool inside = position < stop_of(token);
    if (token.kind == TokenKind::text &&
        (inside || (position == stop_of(token) && (token.text.size() < 2 || token.faulty))))
      return inside_words(token, at > 0 ? &tokens[at - 1] : nullptr, analysis.file, position);
    if ((inside || position == stop_of(token)) && token.kind != TokenKind::sign &&
        token.kind != TokenKind::newline && token.kind != TokenKind::text)
      break;  // the word that is being written
    scanner.read(at);
  }
  const bool word = at < tokens.size() && start_of(tokens[at]) < position;
  Context context = scanner.finish(word ? at + 1 : at);
  context.range = range_at(analysis.file, position);
  if (!word) {
    // Before a name, the position belongs to it, too: hover and replacement see the whole word.
    if (at < tokens.size() && tokens[at].kind == TokenKind::name &&
        start_of(tokens[at]) == position)
      context.range = range_between(analysis.file, position, stop_of(tokens[at]));
    return context;
  }
  const Token& token = tokens[at];
  context.range = range_between(analysis.file, start_of(token), stop_of(token));
  if (token.kind == TokenKind::number) {
    context.place = Place::unit;
    context.range.column += static_cast<int>(unit_begin(token.text));
  } else if (token.kind != TokenKind::name) {
    context.place = Place::nothing;
  }
  return context;
}

}  // namespace vug::language
