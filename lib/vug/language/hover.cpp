// SPDX-License-Identifier: Apache-2.0
#include <vug/language/describe.h>
#include <vug/language/hover.h>
#include <vug/language/values.h>
#include <vug/scene/functions.h>

#include <fmt/format.h>

namespace vug::language {
namespace {

std::string joined(const std::vector<CallMeaning>& meanings) {
  std::string text;
  for (const CallMeaning& each : meanings)
    text += (text.empty() ? "" : "\n\n---\n\n") + describe(each);
  return text;
}

std::string describe_symbol(const Analysis& analysis, const Symbol& symbol) {
  std::string text = describe(symbol, analysis.document);
  const std::map<std::string, std::string> values =
      symbol.kind == SymbolKind::param || symbol.kind == SymbolKind::let
          ? values_of(analysis)
          : std::map<std::string, std::string>();
  if (const auto value = values.find(symbol.full_name); value != values.end())
    text += fmt::format("\n\nValue: `{}`", value->second);
  return text;
}

/// The description of a word of the language, a built-in function or a keyword.
std::string describe_word(const std::string& word, const Context& context) {
  if (context.place == Place::statement) {
    if (const LanguageWord* known = find_word(statement_words(), word)) return describe(*known);
    if (const KindInfo* info = find_declaration(word)) return describe(*info);
    return {};
  }
  if (context.place == Place::grammar_kind)
    if (const KindInfo* info = find_declaration(word)) return describe(*info);
  if (const scene::Function* function = scene::find_function(word))
    return fmt::format("{}\n{}", code_block(fmt::format("{}({})", word, function->takes)),
                       function->doc);
  for (const auto* words : {&value_words(), &inner_words()})
    if (const LanguageWord* known = find_word(*words, word)) return describe(*known);
  return {};
}

std::string describe_at(const Analysis& analysis, const Context& context, const scene::Token& token,
                        const scene::Token& next) {
  const std::string word(token.text);
  const OpenCall* call = context.call();
  if (call && call->begins && next.is(":") && !context.in_list) {
    for (const CallMeaning& each : meanings_at(context, analysis.document))
      if (const ParamInfo* param = find_param(each.info, 0, word)) return describe(*param);
    return {};
  }
  if (context.place == Place::key && context.in_block) {
    Context block = context;
    block.keys.clear();
    for (const ParamInfo& param : missing_entries(block, analysis.document))
      if (param.name == word) return describe(param);
  }
  const Expectation expectation = expectation_at(context, analysis.document);
  const bool called = next.is("(") && next.touches;
  if (!called)
    for (const ParamInfo& param : expectation.params)
      if (has_choice(param, word)) return describe(param);
  OpenCall named;
  named.name = word;
  named.method = context.place == Place::member;
  named.receiver = context.receiver;
  const std::string kinds = context.place == Place::statement
                                ? std::string()
                                : joined(meanings_of(named, analysis.document, expectation.type));
  return kinds.empty() ? describe_word(word, context) : kinds;
}

}  // namespace

std::optional<Hover> hover_at(const Analysis& analysis, const Position& position) {
  if (const Reference* found = analysis.symbols.at(analysis.file, position))
    return Hover{found->where, describe_symbol(analysis, analysis.symbols.of(*found))};
  const int index = token_at(analysis.tokens, position);
  if (index < 0) return std::nullopt;
  const scene::Token& token = analysis.tokens[static_cast<size_t>(index)];
  if (token.kind != scene::TokenKind::name) return std::nullopt;
  const Position begin{token.line, token.column};
  const Context context = context_at(analysis, begin);
  const scene::Token& next = analysis.tokens[static_cast<size_t>(index) + 1];
  std::string text = describe_at(analysis, context, token, next);
  if (text.empty()) return std::nullopt;
  return Hover{range_between(analysis.file, begin, {token.end_line(), token.end_column()}),
               std::move(text)};
}

}  // namespace vug::language
