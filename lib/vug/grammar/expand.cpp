// SPDX-License-Identifier: Apache-2.0
#include <vug/grammar/expand.h>

#include <cmath>
#include <map>

namespace vug::grammar {
namespace {

/// Weight of a production at the node; 0 if it does not apply.
double weight_at(const Production& production, const Node& node, uint64_t index) {
  const auto arity = static_cast<int64_t>(node.symbol.content.params.size());
  if (production.arity >= 0 && production.arity != arity) return 0;
  if (production.guard &&
      !production.guard({node.symbol, node.key.at("guard").at(index), node.key, node.depth}))
    return 0;
  if (!production.weight) return 1;
  const double weight =
      production.weight({node.symbol, node.key.at("weight").at(index), node.key, node.depth});
  if (!(weight >= 0) || std::isinf(weight))
    throw Error(ErrorCode::bad_input,
                "the weight of '" + to_string(production) + "' is " +
                    vug::to_string(Value(weight)) + " at '" + to_string(node.symbol) + "'",
                production.where, "a weight must be a finite number, 0 or more");
  return weight;
}

/// The children of `node` produced by `parts`.
std::vector<Node> apply(const std::vector<SuccessorItem>& parts, const Node& node, int64_t room) {
  std::vector<Node> children;
  std::map<std::string, int64_t> ordinals;
  for (const SuccessorItem& part : parts) {
    const RandomKey named = node.key.at(part.symbol);
    int64_t& ordinal = ordinals[part.symbol];
    int64_t count = 1;
    if (part.count)
      count = part.count({node.symbol, named.at("count").at(static_cast<uint64_t>(ordinal)),
                          node.key, node.depth});
    if (count < 0)
      throw Error(ErrorCode::bad_input,
                  "'" + part.symbol + "' cannot be repeated " + std::to_string(count) + " times",
                  part.where, "a repetition count must be 0 or more");
    if (count > room - static_cast<int64_t>(children.size()))
      throw Error(ErrorCode::too_large,
                  "'" + to_string(node.symbol) + "' makes '" + part.symbol + "' " +
                      std::to_string(count) + " times, which exceeds the limit on symbols",
                  part.where, "add a guard that ends the recursion, or raise 'limit'");
    for (int64_t i = 0; i < count; ++i, ++ordinal) {
      Node child;
      child.symbol.name = part.symbol;
      child.key = named.at(static_cast<uint64_t>(ordinal));
      child.ordinal = ordinal;
      child.terminal = part.terminal;
      if (part.content)
        child.symbol.content =
            part.content({node.symbol, child.key.at("content"), node.key, node.depth, i, count});
      children.push_back(std::move(child));
    }
  }
  return children;
}

}  // namespace

Expansion expand(const Grammar& grammar, const Node& node, int64_t room) {
  Expansion out;
  if (node.terminal) return out;
  std::vector<std::pair<int, double>> candidates;
  double total = 0;
  uint64_t index = 0;  // among the productions of this symbol, so that others do not change keys
  for (size_t p = 0; p < grammar.productions.size(); ++p) {
    const Production& production = grammar.productions[p];
    if (production.symbol != node.symbol.name) continue;
    const double weight = weight_at(production, node, index++);
    if (weight > 0) candidates.emplace_back(static_cast<int>(p), weight);
    total += weight;
  }
  out.stuck = index > 0 && candidates.empty();
  if (candidates.empty()) return out;

  double dart = RandomStream(node.key.at("choice")).uniform() * total;
  size_t chosen = 0;
  while (chosen + 1 < candidates.size() && dart >= candidates[chosen].second)
    dart -= candidates[chosen++].second;
  out.production = candidates[chosen].first;
  out.children =
      apply(grammar.productions[static_cast<size_t>(out.production)].successor, node, room);
  return out;
}

Expansion expand_axiom(const Grammar& grammar, const Node& root, int64_t room) {
  Expansion out;
  out.children = apply(grammar.axiom, root, room);
  return out;
}

}  // namespace vug::grammar
