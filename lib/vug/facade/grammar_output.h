// A derived facade as the text of a grammar that leaves nothing open: to be edited, included and
// carved.
#pragma once

#include <vug/facade/tree.h>

#include <string>

namespace vug::facade {

struct GrammarTextOptions {
  std::string name;      ///< Of the grammar; empty: the tree's.
  double thickness = 0;  ///< Of a wall that it is carved into, metres; 0: as is usual.
};

/// `grammar NAME: facade { ... }` with all sizes, in millimetres. It derives to the same elements
/// with the measures that they were told, at the same places within a millimetre. Trees without
/// nodes are a bare wall.
std::string grammar_text(const Tree& tree, const GrammarTextOptions& options = {});

}  // namespace vug::facade
