// SPDX-License-Identifier: Apache-2.0
#include <vug/grammar/grammar.h>

#include <map>
#include <set>

namespace vug::grammar {

std::string to_string(const Symbol& symbol) {
  if (!symbol.content.text.empty()) return symbol.content.text;
  if (symbol.content.params.empty()) return symbol.name;
  std::string out = symbol.name + "(";
  for (size_t i = 0; i < symbol.content.params.size(); ++i) {
    if (i > 0) out += ", ";
    out += vug::to_string(symbol.content.params[i]);
  }
  return out + ")";
}

std::string to_string(const Production& production) {
  if (!production.name.empty()) return production.name;
  std::string out = production.symbol + " ->";
  for (const SuccessorItem& part : production.successor) out += " " + part.symbol;
  return out;
}

namespace {

struct Checker {
  const Grammar& grammar;
  Diagnostics& diagnostics;
  std::multimap<std::string, const Production*> by_symbol;
  std::set<std::string> reached;

  void visit(const std::vector<SuccessorItem>& parts, std::vector<std::string>& pending) {
    for (const SuccessorItem& part : parts) {
      if (part.terminal) continue;
      if (by_symbol.count(part.symbol) == 0) {
        std::vector<std::string> known;
        for (const auto& entry : by_symbol)
          if (known.empty() || known.back() != entry.first) known.push_back(entry.first);
        diagnostics.error(part.where, "no production rewrites '" + part.symbol + "'",
                          suggestion(part.symbol, known));
      } else if (reached.insert(part.symbol).second) {
        pending.push_back(part.symbol);
      }
    }
  }
};

}  // namespace

void check(const Grammar& grammar, Diagnostics& diagnostics) {
  if (grammar.axiom.empty())
    diagnostics.error(grammar.where, "grammar '" + grammar.name + "' has no axiom");
  Checker checker{grammar, diagnostics, {}, {}};
  for (const Production& production : grammar.productions)
    checker.by_symbol.emplace(production.symbol, &production);

  std::vector<std::string> pending;
  checker.visit(grammar.axiom, pending);
  while (!pending.empty()) {
    const std::string symbol = std::move(pending.back());
    pending.pop_back();
    const auto range = checker.by_symbol.equal_range(symbol);
    for (auto it = range.first; it != range.second; ++it)
      checker.visit(it->second->successor, pending);
  }
  for (const Production& production : grammar.productions)
    if (checker.reached.count(production.symbol) == 0)
      diagnostics.warning(production.where,
                          "the production '" + to_string(production) + "' is unreachable");
}

}  // namespace vug::grammar
