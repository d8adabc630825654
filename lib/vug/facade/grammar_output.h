// A derived facade as the text of a grammar that leaves nothing open: to be edited, included and
// carved.
#pragma once

#include <vug/facade/tree.h>

#include <map>
#include <string>

namespace vug::facade {

struct GrammarTextOptions {
  std::string name;  ///< Of the grammar; empty: the tree's.
  /// What to write for elements of a kind, such as "window(reveal: 20cm)"; without an entry its
  /// name, which means the kind's usual measures.
  std::map<std::string, std::string> elements;
};

/// `grammar NAME: facade { ... }` with all sizes, in millimetres. It derives to the same elements
/// at the same places, within a millimetre. Trees without nodes are a bare wall.
std::string grammar_text(const Tree& tree, const GrammarTextOptions& options = {});

}  // namespace vug::facade
