// SPDX-License-Identifier: Apache-2.0
#include <vug/language/context.h>
#include <vug/language/fixes.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace vug::language {
namespace {

/// The part of a text between two others; nothing if it does not contain them.
std::optional<std::string> between(const std::string& text, const std::string& before,
                                   const std::string& after) {
  const size_t begin = text.find(before);
  if (begin == text.npos) return std::nullopt;
  const size_t from = begin + before.size();
  const size_t end = after.empty() ? text.size() : text.find(after, from);
  if (end == text.npos) return std::nullopt;
  return text.substr(from, end - from);
}

SourceLocation where_of(const Analysis& analysis, const scene::Token& token) {
  return {analysis.file, token.line, token.column, token.end_line(), token.end_column()};
}

/// The token in the range that the message quotes; nothing if there is none.
std::optional<SourceLocation> quoted_token(const Analysis& analysis, const Diagnostic& diagnostic) {
  const SourceLocation& range = diagnostic.where;
  for (size_t at = 0; (at = diagnostic.message.find('\'', at)) != std::string::npos; ++at) {
    const size_t end = diagnostic.message.find('\'', at + 1);
    if (end == std::string::npos) break;
    const std::string word = diagnostic.message.substr(at + 1, end - at - 1);
    for (const scene::Token& token : analysis.tokens) {
      const SourceLocation where = where_of(analysis, token);
      const std::string text = token.kind == scene::TokenKind::text ? scene::unquote(token.text)
                                                                    : std::string(token.text);
      if (text == word && begin_of(where) >= begin_of(range) &&
          (!range.has_end() || end_of(where) <= end_of(range)))
        return where;
    }
  }
  return std::nullopt;
}

/// The number of an unknown unit, e.g. the range of "mmm" in "3mmm".
std::optional<SourceLocation> unit_range(const Analysis& analysis, const Diagnostic& diagnostic) {
  const auto unit = between(diagnostic.message, "unknown unit '", "'");
  if (!unit || !diagnostic.where.has_end()) return std::nullopt;
  SourceLocation where = diagnostic.where;
  where.file = analysis.file;
  where.column = where.end_column - static_cast<int>(unit->size());
  return where;
}

/// The line before which an include is inserted: after the comments at the beginning of the text.
int first_statement_line(const Analysis& analysis) {
  for (const scene::Token& token : analysis.tokens)
    if (token.kind != scene::TokenKind::comment && token.kind != scene::TokenKind::newline)
      return token.line;
  return 1;
}

/// A name for a new param: that of the argument or entry, made unique.
std::string free_name(const Analysis& analysis, std::string name) {
  if (name.empty()) name = "value";
  const auto taken = [&](const std::string& wanted) {
    return std::any_of(analysis.tokens.begin(), analysis.tokens.end(),
                       [&](const scene::Token& token) { return token.text == wanted; }) &&
           std::any_of(analysis.symbols.symbols.begin(), analysis.symbols.symbols.end(),
                       [&](const Symbol& symbol) { return symbol.name == wanted; });
  };
  std::string free = name;
  for (int i = 2; taken(free); ++i) free = fmt::format("{}{}", name, i);
  return free;
}

}  // namespace

std::vector<Fix> fixes_for(const Analysis& analysis, const Diagnostic& diagnostic) {
  std::vector<Fix> fixes;
  if (diagnostic.where.file != analysis.file || !diagnostic.where.known()) return fixes;
  const std::string& hint = diagnostic.hint;
  if (const auto name = between(hint, "did you mean '", "'?")) {
    auto range = unit_range(analysis, diagnostic);
    if (!range) range = quoted_token(analysis, diagnostic);
    const int token = range ? token_at(analysis.tokens, end_of(*range)) : -1;
    const bool quoted =
        token >= 0 && analysis.tokens[static_cast<size_t>(token)].kind == scene::TokenKind::text;
    if (range)
      fixes.push_back({fmt::format("Replace by '{}'", *name),
                       {{*range, quoted ? fmt::format("\"{}\"", *name) : *name}}});
  }
  if (const auto file = between(hint, "'include \"", "\" as");
      file && hint.find("declares") != hint.npos) {
    const auto line = between(hint, "'", "' declares");
    const auto member = between(hint, "declares '", "'");
    const auto range = quoted_token(analysis, diagnostic);
    if (line && member && range)
      fixes.push_back(
          {fmt::format("Include \"{}\"", *file),
           {{range_at(analysis.file, {first_statement_line(analysis), 1}), *line + "\n"},
            {*range, *member}}});
  }
  if (hint.starts_with("write srgb(") && diagnostic.where.has_end())
    fixes.push_back(
        {fmt::format("Replace by {}", hint.substr(6)), {{diagnostic.where, hint.substr(6)}}});
  return fixes;
}

std::vector<Fix> refactorings_at(const Analysis& analysis, const Position& position) {
  std::vector<Fix> fixes;
  const int index = token_at(analysis.tokens, position);
  if (index < 0 || analysis.diagnostics.has_errors()) return fixes;
  const scene::Token& token = analysis.tokens[static_cast<size_t>(index)];
  if (token.kind != scene::TokenKind::number) return fixes;
  const Context context = context_at(analysis, {token.line, token.column});
  if (context.keyword == "param" || context.keyword == "seed" || context.keyword.empty())
    return fixes;
  const OpenCall* call = context.call();
  const std::string name =
      free_name(analysis, call && !call->argument.empty() ? call->argument : context.key);
  int line = token.line;  // of the statement
  for (const Symbol& symbol : analysis.symbols.symbols)
    if (!symbol.scope.known() && symbol.extent.contains(where_of(analysis, token)))
      line = symbol.extent.line;
  fixes.push_back(
      {fmt::format("Make a param '{}' of {}", name, token.text),
       {{range_at(analysis.file, {line, 1}), fmt::format("param {} = {}\n", name, token.text)},
        {where_of(analysis, token), name}}});
  return fixes;
}

}  // namespace vug::language
