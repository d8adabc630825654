// SPDX-License-Identifier: Apache-2.0
// Conversion of existing trees, such as fitted ones, into edits that reproduce them.
#pragma once

#include <vug/modeller/edit.h>

#include <string>

namespace vug::modeller {

struct TreeEdits {
  std::vector<Edit> edits;  ///< In the order of execution.
  size_t elements = 0;      ///< Elements in the tree.
  /// Elements that are a centimetre or more away from their position in the tree.
  size_t displaced = 0;
  double max_distance = 0;  ///< Largest such distance, metres.
  size_t missing = 0;       ///< Elements without a counterpart of their kind.
};

/// A sentence about the deviation of the edits from their tree, without a final stop; empty if
/// there is none.
std::string deviation_text(const TreeEdits& edits);

/// Applies the rules of the tree's nodes again, with the sizes and counts of its rectangles and
/// with empty cells of grids removed. If a rule of the style has fewer free numbers than the tree
/// requires (one size for all windows of a grid, elements that fill their part), the result is the
/// closest that the rules allow, and the deviation is reported; positions of cells take precedence
/// over their sizes. Also accepts the grammar that facade::grammar_text writes for the tree.
/// Error(bad_input) for a tree of another grammar.
TreeEdits tree_to_edits(const FacadeState& start, const facade::Tree& tree);

/// Reads a tree from the JSON written by facade::tree_json. Error(bad_input) with line, column, the
/// value's JSON pointer and a hint. `file` names the text in messages.
facade::Tree read_tree(const std::string& text, const std::string& file);

}  // namespace vug::modeller
