// Trees that something else has made, such as fits of pictures, as edits that lead there.
#pragma once

#include <vug/modeller/edit.h>

namespace vug::modeller {

struct TreeEdits {
  std::vector<Edit> edits;  ///< To be done one after the other.
  size_t elements = 0;      ///< That stand in the tree,
  size_t displaced = 0;  ///< and of these such as stand elsewhere after the edits, by a centimetre
  double max_distance = 0;  ///< or more: this far at most, metres.
  size_t missing = 0;       ///< And such as have nothing of their kind left.
};

/// The rules of the tree's nodes applied again, with the sizes and counts that its rectangles tell
/// and cells of grids taken away. Where a rule of the style leaves less free than the tree's maker
/// took (one size for all windows of a grid, elements that fill their part) it comes as near as the
/// rules do, and says how near; places of a grid's cells go before their size. The grammar that
/// facade::grammar_text writes of the tree will do too. Error(bad_input) for a tree of another one.
TreeEdits tree_to_edits(const FacadeState& start, const facade::Tree& tree);

/// A tree from the JSON that facade::tree_json writes. Error(bad_input) with line, column, the
/// value's pointer and a hint. `file` names the text in messages.
facade::Tree read_tree(const std::string& text, const std::string& file);

}  // namespace vug::modeller
