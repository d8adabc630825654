// SPDX-License-Identifier: Apache-2.0
// The selected node of a facade, which survives edits, and steps to its relatives.
#pragma once

#include <vug/modeller/facade_state.h>

#include <string>
#include <vector>

namespace vug::workbench {

class Selection {
 public:
  /// The node; if edits have removed it, its nearest ancestor that exists; kWhole in an empty tree.
  int node(const modeller::FacadeState& state) const;
  void set(const modeller::FacadeState& state, int node);

 private:
  std::vector<facade::PartKey> keys_;
};

/// The relative of a node: "parent", "child", "next" or "previous" sibling, or "open", the next
/// undivided node in the order of the tree. The node itself if it has no such relative.
/// Error(bad_input) for other words.
int relative(const modeller::FacadeState& state, int node, const std::string& which);

}  // namespace vug::workbench
