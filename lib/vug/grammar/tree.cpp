// SPDX-License-Identifier: Apache-2.0
#include <vug/grammar/tree.h>

namespace vug::grammar {

std::string Tree::path(int node) const {
  std::vector<const Node*> chain;
  for (int n = node; n >= 0; n = nodes[static_cast<size_t>(n)].parent)
    chain.push_back(&nodes[static_cast<size_t>(n)]);
  std::string out;
  for (auto it = chain.rbegin(); it != chain.rend(); ++it) {
    if (!out.empty()) out += '/';
    out += (*it)->symbol.name;
    if ((*it)->parent >= 0) out += '[' + std::to_string((*it)->ordinal) + ']';
  }
  return out;
}

std::vector<int> Tree::leaves() const {
  std::vector<int> out, stack;
  if (!nodes.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    const Node& at = nodes[static_cast<size_t>(node)];
    // A symbol erased by a production has no children, but it is not a leaf of the word.
    if (at.children.empty() && at.production < 0 && at.parent >= 0) out.push_back(node);
    stack.insert(stack.end(), at.children.rbegin(), at.children.rend());
  }
  return out;
}

}  // namespace vug::grammar
