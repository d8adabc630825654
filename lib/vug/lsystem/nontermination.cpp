// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/nontermination.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::lsystem {

namespace {

/// Symbols that the stage produces from `symbol` regardless of random choices and parameters: the
/// intersection of the successors of all applicable rules, if one of them certainly applies.
std::vector<SymbolId> certain_successors(const System& system, const RuleBook& book,
                                         SymbolId symbol) {
  std::vector<SymbolId> made;
  bool certain = false;
  const RuleSelection& rules = book.symbols[symbol];
  for (uint32_t r = rules.first; r < rules.end; ++r) {
    const Production& p = system.productions[book.rules[r]];
    std::vector<SymbolId> own(p.symbols), both;
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    std::set_intersection(made.begin(), made.end(), own.begin(), own.end(),
                          std::back_inserter(both));
    made = r == rules.first ? own : both;
    certain = certain || p.guard.empty();
    if (p.guard.empty() && p.weight.empty()) break;  // later rules are never applied
  }
  return certain ? made : std::vector<SymbolId>();
}

/// A cycle of symbols in which each one produces the next; empty if there is none.
std::vector<SymbolId> cycle(const System& system, const RuleBook& book) {
  const size_t count = system.alphabet.size();
  std::vector<std::vector<SymbolId>> makes(count), made_by(count);
  std::vector<size_t> left(count);  // number of its products that may not terminate
  for (size_t s = 0; s < count; ++s) {
    makes[s] = certain_successors(system, book, static_cast<SymbolId>(s));
    left[s] = makes[s].size();
    for (const SymbolId next : makes[s]) made_by[next].push_back(static_cast<SymbolId>(s));
  }
  std::vector<SymbolId> ends;
  for (size_t s = 0; s < count; ++s)
    if (left[s] == 0) ends.push_back(static_cast<SymbolId>(s));
  for (size_t i = 0; i < ends.size(); ++i)
    for (const SymbolId before : made_by[ends[i]])
      if (--left[before] == 0) ends.push_back(before);
  const auto lasting = [&](SymbolId symbol) { return left[symbol] > 0; };

  const auto start = std::find_if(left.begin(), left.end(), [](size_t n) { return n > 0; });
  if (start == left.end()) return {};
  std::vector<SymbolId> way{static_cast<SymbolId>(start - left.begin())};
  for (;;) {
    const auto& next = makes[way.back()];
    const SymbolId to = *std::find_if(next.begin(), next.end(), lasting);
    const auto seen = std::find(way.begin(), way.end(), to) - way.begin();
    way.push_back(to);
    if (static_cast<size_t>(seen) + 1 < way.size()) return {way.begin() + seen, way.end()};
  }
}

}  // namespace

bool check_termination(const System& system, Diagnostics& diagnostics) {
  bool sound = true;
  for (const auto& [stage, name] : {std::pair(&system.decompose, "decomposition"),
                                    std::pair(&system.interpret, "interpretation")}) {
    if (stage->depth || stage->book.empty()) continue;
    const std::vector<SymbolId> way = cycle(system, stage->book);
    if (way.empty()) continue;
    std::string names;
    for (const SymbolId symbol : way)
      names += (names.empty() ? "" : " -> ") + system.alphabet.name(symbol);
    const Production& rule =
        system.productions[stage->book.rules[stage->book.symbols[way[0]].first]];
    diagnostics.error(rule.where,
                      fmt::format("the {} of '{}' never terminates: {}", name, rule.text, names),
                      "add a guard that ends it, or set a 'depth' for the block");
    sound = false;
  }
  return sound;
}

}  // namespace vug::lsystem
