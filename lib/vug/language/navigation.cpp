// SPDX-License-Identifier: Apache-2.0
#include <vug/language/navigation.h>

#include <algorithm>
#include <tuple>

namespace vug::language {

namespace fs = std::filesystem;

namespace {

bool is_same(const Symbol& a, const Symbol& b) {
  return begin_of(a.where) == begin_of(b.where) && is_same_file(a.where.file, b.where.file);
}

auto order(const Reference& one) {
  return std::tie(one.where.file, one.where.line, one.where.column);
}

void sort_and_merge(std::vector<Reference>& all) {
  std::sort(all.begin(), all.end(),
            [](const Reference& a, const Reference& b) { return order(a) < order(b); });
  all.erase(
      std::unique(all.begin(), all.end(),
                  [](const Reference& a, const Reference& b) { return order(a) == order(b); }),
      all.end());
}

}  // namespace

std::optional<Symbol> symbol_at(const Analysis& analysis, const Position& position) {
  const Reference* found = analysis.symbols.at(analysis.file, position);
  if (!found) return std::nullopt;
  return analysis.symbols.of(*found);
}

SourceLocation definition_at(const Analysis& analysis, const Position& position) {
  if (const auto symbol = symbol_at(analysis, position)) return symbol->where;
  for (const auto& source : analysis.document.sources)
    if (source->included_from.file == analysis.file && touches(source->included_from, position))
      return {source->file, 1, 1, 1, 1};
  return {};
}

std::vector<Reference> references_in(const Analysis& analysis, const Symbol& symbol) {
  std::vector<Reference> all;
  for (const Reference& each : analysis.symbols.references)
    if (is_same(analysis.symbols.of(each), symbol)) all.push_back(each);
  sort_and_merge(all);
  return all;
}

std::vector<Reference> references_of(const Workspace& workspace, const Analysis& analysis,
                                     const Symbol& symbol) {
  std::vector<Reference> all = references_in(analysis, symbol);
  if (symbol.scope.known()) return all;
  for (const fs::path& file : workspace.files_with(symbol.name)) {
    if (is_same_file(file, analysis.file)) continue;
    const AnalysisPtr other = workspace.analyse(file);
    for (Reference& each : references_in(*other, symbol)) {
      for (const Reference& known : all)
        if (begin_of(known.where) == begin_of(each.where) &&
            is_same_file(known.where.file, each.where.file))
          each.where.file = known.where.file;
      all.push_back(each);
    }
  }
  sort_and_merge(all);
  return all;
}

}  // namespace vug::language
