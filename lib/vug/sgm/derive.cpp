// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/derive.h>

#include <fmt/format.h>

#include <utility>

namespace vug::sgm {

DerivationResult interpret(grammar::Tree tree, const Options& options, Progress& progress) {
  Growth growth(options);
  DerivationResult out;
  const std::vector<int> leaves = tree.leaves();
  std::vector<std::pair<int, std::string>> ineffective;  // Leaves with the reason.
  progress.begin("growing", leaves.size());
  for (const int leaf : leaves) {
    progress.check();
    const grammar::Node& node = tree.nodes[static_cast<size_t>(leaf)];
    const ProductionStep* step = std::any_cast<ProductionStep>(&node.symbol.content.payload);
    const bool undressed =
        node.stuck && std::any_cast<Transform>(&node.symbol.content.payload) != nullptr;
    if (undressed) continue;  // an element of a network to which no rule applies
    if (!step) {
      out.diagnostics.warning({}, fmt::format("'{}' at {} was never expanded to a production",
                                              grammar::to_string(node.symbol), tree.path(leaf)));
      continue;
    }
    try {
      const Placement& placement = growth.apply(*step, node.key.at("placement"), leaf);
      if (!placement.effective)
        ineffective.emplace_back(
            leaf,
            fmt::format(" ({}: {})", placement.refused ? "left out" : "no effect", placement.note));
    } catch (Error& e) {
      throw e.within("growing " + tree.path(leaf));
    }
    ++(step->operation == Operation::morph ? out.counts.morphic : out.counts.classic);
    progress.advance();
  }
  progress.end();
  for (const auto& [leaf, reason] : ineffective)
    tree.nodes[static_cast<size_t>(leaf)].symbol.content.text += reason;
  out.field = growth.field();
  out.bonds = growth.free_bonds();
  out.operations = growth.placements();
  for (const Placement& each : out.operations)
    if (each.effective && !each.name.empty()) out.places.push_back({each.name, each.middle()});
  for (const Diagnostic& d : growth.diagnostics().all())
    out.diagnostics.warning(d.where, d.message);
  out.tree = std::move(tree);
  return out;
}

DerivationResult derive(const grammar::Grammar& grammar, RandomKey key, const Options& options,
                        const grammar::Limits& limits, Progress& progress) {
  return interpret(grammar::derive(grammar, key, limits, {}, progress), options, progress);
}

DerivationResult derive(const Rules& rules, RandomKey key, const Options& options,
                        const grammar::Limits& limits, Progress& progress) {
  return derive(grammar_of(rules), key, options, limits, progress);
}

}  // namespace vug::sgm
