// SPDX-License-Identifier: Apache-2.0
#include <vug/language/outline.h>

#include <algorithm>
#include <map>

namespace vug::language {

std::vector<OutlineItem> outline_of(const Analysis& analysis) {
  std::vector<OutlineItem> items;
  std::map<int, size_t> places;  // of global symbols
  const auto& symbols = analysis.symbols.symbols;
  const auto item_of = [](const Symbol& symbol) {
    SourceLocation extent = symbol.extent;
    if (!extent.contains(symbol.where)) extent = symbol.where;
    return OutlineItem{symbol.name, description(symbol), symbol.kind, extent, symbol.where, {}};
  };
  for (size_t i = 0; i < symbols.size(); ++i) {
    if (symbols[i].where.file != analysis.file || symbols[i].scope.known()) continue;
    places[static_cast<int>(i)] = items.size();
    items.push_back(item_of(symbols[i]));
  }
  for (const Symbol& symbol : symbols) {
    const auto outer = places.find(symbol.outer);
    const bool part = symbol.kind == SymbolKind::rule || symbol.kind == SymbolKind::table;
    if (!part || outer == places.end()) continue;
    OutlineItem child = item_of(symbol);
    OutlineItem& parent = items[outer->second];
    if (parent.extent.contains(child.extent)) parent.children.push_back(std::move(child));
  }
  const auto earlier = [](const OutlineItem& a, const OutlineItem& b) {
    return begin_of(a.extent) < begin_of(b.extent);
  };
  std::stable_sort(items.begin(), items.end(), earlier);
  for (OutlineItem& item : items)
    std::stable_sort(item.children.begin(), item.children.end(), earlier);
  return items;
}

std::vector<Fold> folds_of(const Analysis& analysis) {
  std::map<int, Fold> folds;  // the longest of each first line
  const auto add = [&](int first, int last, bool comment) {
    if (last <= first) return;
    const auto [place, fresh] = folds.try_emplace(first, Fold{first, last, comment});
    if (!fresh && last > place->second.last_line) place->second = {first, last, comment};
  };
  std::vector<const scene::Token*> open;
  const scene::Token* first_comment = nullptr;
  int last_comment = 0;
  for (const scene::Token& token : analysis.tokens) {
    if (token.is("(") || token.is("[") || token.is("{")) open.push_back(&token);
    if ((token.is(")") || token.is("]") || token.is("}")) && !open.empty()) {
      add(open.back()->line, token.line, false);
      open.pop_back();
    }
    const bool comment = token.kind == scene::TokenKind::comment;
    if (comment && first_comment && token.line == last_comment + 1) {
      last_comment = token.line;
    } else if (comment) {
      if (first_comment) add(first_comment->line, last_comment, true);
      first_comment = &token;
      last_comment = token.line;
    }
  }
  if (first_comment) add(first_comment->line, last_comment, true);
  for (const OutlineItem& item : outline_of(analysis))
    add(item.extent.line, item.extent.end_line, false);
  std::vector<Fold> all;
  for (const auto& [line, fold] : folds) all.push_back(fold);
  return all;
}

}  // namespace vug::language
