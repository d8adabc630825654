// SPDX-License-Identifier: Apache-2.0
// Conversion of a derivation to the tree of a facade.
#include <vug/facade/scope.h>

namespace vug::facade {

namespace {

/// The last part of "Facade/0/1/columns", the form of the names of splits inside splits.
std::string plain(const std::string& name) {
  const size_t slash = name.rfind('/');
  return slash == std::string::npos ? name : name.substr(slash + 1);
}

/// Moves the numbers of the children's splits to the node that they divide.
void read_splits(const grammar::Tree& derivation, const grammar::Node& from, Node& to) {
  const Layout* last = nullptr;
  int splits = 0;
  for (const int child : from.children) {
    const auto& scope = std::any_cast<const Scope&>(
        derivation.nodes[static_cast<size_t>(child)].symbol.content.payload);
    if (!scope.layout || scope.layout.get() == last) continue;
    last = scope.layout.get();
    to.split = ++splits == 1 ? scope.split : "";
    to.numbers.insert(to.numbers.end(), last->numbers.begin(), last->numbers.end());
  }
}

}  // namespace

Tree tree_of(const grammar::Tree& derivation) {
  Tree out;
  out.name = derivation.nodes.at(0).symbol.name;
  for (size_t i = 1; i < derivation.nodes.size(); ++i) {
    const grammar::Node& from = derivation.nodes[i];
    const auto& scope = std::any_cast<const Scope&>(from.symbol.content.payload);
    Node to;
    to.symbol = plain(from.symbol.name);
    to.text = grammar::to_string({to.symbol, {from.symbol.content.params, {}, {}}});
    to.parent = from.parent - 1;
    for (const int child : from.children) to.children.push_back(child - 1);
    to.rect = scope.rect;
    to.copies = scope.copies;
    to.given = scope.given;
    to.mirrored = scope.mirrored;
    to.depth = scope.depth;
    to.element = scope.element;
    to.stuck = from.stuck;
    if (from.production >= 0 && from.symbol.name == to.symbol)
      to.rule = derivation.productions[static_cast<size_t>(from.production)].name;
    read_splits(derivation, from, to);
    out.nodes.push_back(std::move(to));
  }
  return out;
}

}  // namespace vug::facade
