// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/grammar/derive.h>
#include <vug/grammar/expand.h>

#include <algorithm>

namespace vug::grammar {
namespace {

/// A tree under construction, with its limits.
class Builder {
 public:
  Builder(const Grammar& grammar, RandomKey key, const Limits& limits)
      : grammar_(grammar), limits_(limits) {
    for (const Production& p : grammar.productions)
      tree_.productions.push_back({to_string(p), p.symbol, p.where});
    Node root;
    root.symbol.name = grammar.name;
    root.key = key;
    tree_.nodes.push_back(std::move(root));
    attach(0, expand_axiom(grammar, tree_.nodes[0], room()));
  }

  Tree& tree() { return tree_; }
  int64_t room() const { return limits_.symbols - static_cast<int64_t>(tree_.nodes.size()); }
  Expansion expand(int node) const {
    return grammar::expand(grammar_, tree_.nodes[static_cast<size_t>(node)], room());
  }

  /// Appends the children; counts the production against the limits.
  void attach(int node, Expansion expansion) {
    const auto index = static_cast<size_t>(node);
    tree_.nodes[index].production = expansion.production;
    tree_.nodes[index].stuck = expansion.stuck;
    if (expansion.production >= 0 && ++tree_.applied > limits_.productions)
      refuse(node, "productions", limits_.productions);
    if (static_cast<int64_t>(expansion.children.size()) > room())
      refuse(node, "symbols", limits_.symbols);
    const int depth = tree_.nodes[index].depth + 1;
    for (Node& child : expansion.children) {
      child.parent = node;
      child.depth = depth;
      tree_.nodes[index].children.push_back(static_cast<int>(tree_.nodes.size()));
      tree_.nodes.push_back(std::move(child));
    }
  }

 private:
  [[noreturn]] void refuse(int node, const std::string& what, int64_t limit) const {
    const Node& at = tree_.nodes[static_cast<size_t>(node)];
    const SourceLocation where =
        at.production < 0 ? grammar_.where
                          : grammar_.productions[static_cast<size_t>(at.production)].where;
    throw Error(ErrorCode::too_large,
                "grammar '" + grammar_.name + "' exceeds its limit of " + std::to_string(limit) +
                    " " + what + " while rewriting '" + to_string(at.symbol) + "'",
                where,
                "add a guard that ends the recursion, or raise '" +
                    std::string(what == "symbols" ? "limit" : "steps") + "'");
  }

  const Grammar& grammar_;
  Limits limits_;
  Tree tree_;
};

/// The tree with its nodes numbered in depth-first order.
Tree renumbered(Tree tree) {
  std::vector<int> order, name(tree.nodes.size());
  order.reserve(tree.nodes.size());
  std::vector<int> stack{0};
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    name[static_cast<size_t>(node)] = static_cast<int>(order.size());
    order.push_back(node);
    const auto& children = tree.nodes[static_cast<size_t>(node)].children;
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
  std::vector<Node> nodes;
  nodes.reserve(order.size());
  for (const int old : order) {
    Node node = std::move(tree.nodes[static_cast<size_t>(old)]);
    if (node.parent >= 0) node.parent = name[static_cast<size_t>(node.parent)];
    for (int& child : node.children) child = name[static_cast<size_t>(child)];
    nodes.push_back(std::move(node));
  }
  tree.nodes = std::move(nodes);
  return tree;
}

}  // namespace

Tree derive(const Grammar& grammar, RandomKey key, const Limits& limits,
            const std::function<void(const Tree&, int)>& visit, Progress& progress) {
  Builder builder(grammar, key, limits);
  std::vector<int> stack;
  const auto push_children = [&](int node) {
    const auto& children = builder.tree().nodes[static_cast<size_t>(node)].children;
    stack.insert(stack.end(), children.rbegin(), children.rend());
  };
  push_children(0);
  while (!stack.empty()) {
    progress.check();
    const int node = stack.back();
    stack.pop_back();
    builder.attach(node, builder.expand(node));
    if (visit && builder.tree().nodes[static_cast<size_t>(node)].production < 0)
      visit(builder.tree(), node);
    push_children(node);
  }
  return renumbered(std::move(builder.tree()));
}

Tree derive_parallel(const Grammar& grammar, RandomKey key, int generations, const Limits& limits,
                     Progress& progress) {
  // Expand in blocks, so that an exploding generation stops near the limit.
  constexpr size_t kBlock = 4096;
  Builder builder(grammar, key, limits);
  std::vector<int> frontier = builder.tree().nodes[0].children;
  for (int g = 0; g != generations && !frontier.empty(); ++g) {
    std::vector<int> next;
    for (size_t begin = 0; begin < frontier.size(); begin += kBlock) {
      progress.check();
      std::vector<Expansion> expansions(std::min(kBlock, frontier.size() - begin));
      parallel_for(
          expansions.size(), [&](size_t i) { expansions[i] = builder.expand(frontier[begin + i]); },
          64);
      for (size_t i = 0; i < expansions.size(); ++i) {
        const int node = frontier[begin + i];
        builder.attach(node, std::move(expansions[i]));
        const auto& children = builder.tree().nodes[static_cast<size_t>(node)].children;
        next.insert(next.end(), children.begin(), children.end());
      }
    }
    frontier = std::move(next);
  }
  return std::move(builder.tree());
}

}  // namespace vug::grammar
