// SPDX-License-Identifier: Apache-2.0
// The structure of a text: its declarations as a tree, and the ranges that editors fold.
#pragma once

#include <vug/language/workspace.h>

#include <string>
#include <vector>

namespace vug::language {

struct OutlineItem {
  std::string name;
  std::string detail;  ///< "light", "param", ...
  SymbolKind kind = SymbolKind::let;
  SourceLocation extent;  ///< Contains those of its children, and `where`.
  SourceLocation where;
  std::vector<OutlineItem> children;  ///< Rules and tables of a grammar.
};
/// The declarations of the text itself, in its order.
std::vector<OutlineItem> outline_of(const Analysis& analysis);

struct Fold {
  int first_line = 0, last_line = 0;
  bool comment = false;
};
/// Statements, blocks, lists and comments of several lines, by their first line.
std::vector<Fold> folds_of(const Analysis& analysis);

}  // namespace vug::language
