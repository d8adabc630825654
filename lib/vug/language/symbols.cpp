// SPDX-License-Identifier: Apache-2.0
#include <vug/language/symbols.h>

#include <map>
#include <set>

namespace vug::language {

const Reference* SymbolTable::at(const std::string& file, const Position& position) const {
  const Reference* found = nullptr;
  for (const Reference& each : references) {
    if (each.where.file != file || !touches(each.where, position)) continue;
    // At the border of two names, the position belongs to the one that begins there.
    if (!found || begin_of(found->where) < begin_of(each.where)) found = &each;
  }
  return found;
}

std::vector<const Symbol*> SymbolTable::visible_at(const std::string& file,
                                                   const Position& position) const {
  std::vector<const Symbol*> all;
  for (const Symbol& each : symbols)
    if (!each.scope.known() || (each.scope.file == file && touches(each.scope, position)))
      all.push_back(&each);
  return all;
}

void add_uncertain_references(const std::vector<scene::Token>& tokens, const std::string& file,
                              SymbolTable& table) {
  std::map<std::string, int> globals;
  for (size_t i = 0; i < table.symbols.size(); ++i)
    if (!table.symbols[i].scope.known())
      globals.emplace(table.symbols[i].full_name, static_cast<int>(i));
  std::set<Position> taken;
  for (const Reference& each : table.references)
    if (each.where.file == file) taken.insert(begin_of(each.where));
  for (size_t i = 0; i < tokens.size(); ++i) {
    const scene::Token& token = tokens[i];
    if (token.kind != scene::TokenKind::name || taken.count({token.line, token.column})) continue;
    const bool member = i > 0 && tokens[i - 1].is(".");
    const bool named = i + 1 < tokens.size() && tokens[i + 1].is(":");
    const auto symbol = globals.find(std::string(token.text));
    if (member || named || symbol == globals.end()) continue;
    table.references.push_back(
        {{file, token.line, token.column, token.end_line(), token.end_column()},
         symbol->second,
         false,
         false});
  }
}

std::string description(const Symbol& symbol) {
  switch (symbol.kind) {
    case SymbolKind::rule:
      return "symbol";
    case SymbolKind::table:
      return "table";
    case SymbolKind::module:
      return "module";
    case SymbolKind::parameter:
      return "parameter";
    case SymbolKind::local:
      return "local name";
    case SymbolKind::variable:
      return "loop variable";
    default:
      return symbol.keyword;
  }
}

}  // namespace vug::language
