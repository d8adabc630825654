// SPDX-License-Identifier: Apache-2.0
// Output of derivation trees as indented text.
#include <vug/grammar/tree_output.h>

namespace vug::grammar {

std::string tree_text(const Tree& tree, const TextOptions& options) {
  struct Entry {
    int node;
    std::string prefix;  ///< Start of the lines of this node's children.
    std::string branch;  ///< Start of the node's own line.
  };
  std::string out;
  std::vector<Entry> stack;
  if (!tree.nodes.empty()) stack.push_back({0, "", ""});
  while (!stack.empty()) {
    const Entry entry = std::move(stack.back());
    stack.pop_back();
    const Node& node = tree.nodes[static_cast<size_t>(entry.node)];
    out += entry.branch + to_string(node.symbol);
    if (options.provenance && node.production >= 0) {
      const ProductionInfo& p = tree.productions[static_cast<size_t>(node.production)];
      out += "  ⟵ " + p.name;
      if (p.where.known()) out += " (" + vug::to_string(p.where) + ")";
    }
    if (node.stuck) out += "  (no production applies)";
    out += '\n';
    for (size_t i = node.children.size(); i-- > 0;) {
      const bool last = i + 1 == node.children.size();
      stack.push_back({node.children[i], entry.prefix + (last ? "   " : "│  "),
                       entry.prefix + (last ? "└─ " : "├─ ")});
    }
  }
  return out;
}

}  // namespace vug::grammar
