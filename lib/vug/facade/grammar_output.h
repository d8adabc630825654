// SPDX-License-Identifier: Apache-2.0
// Output of a derived facade as the text of a deterministic grammar, to be edited, included and
// carved.
#pragma once

#include <vug/facade/tree.h>

#include <string>

namespace vug::facade {

struct GrammarTextOptions {
  std::string name;      ///< Name of the grammar; empty: the tree's name.
  double thickness = 0;  ///< Thickness of the wall, metres; 0: the default.
  /// Write uneven grids as columns with symbols of their own, which are easier to edit. Otherwise
  /// rules have the structure of the tree, which modeller::tree_to_edits can find again.
  bool columns = true;
};

/// `grammar NAME: facade { ... }` with all sizes, in millimetres. Its derivation has the same
/// elements with the same arguments at the same positions within a millimetre. A tree without nodes
/// is a plain wall.
std::string grammar_text(const Tree& tree, const GrammarTextOptions& options = {});

}  // namespace vug::facade
