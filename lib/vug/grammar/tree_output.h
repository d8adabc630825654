// SPDX-License-Identifier: Apache-2.0
// Output of derivation trees as text, JSON and SVG. The same tree always gives the same bytes.
#pragma once

#include <vug/grammar/tree.h>

namespace vug::grammar {

struct TextOptions {
  bool provenance = true;  ///< Append the production and its location in the user's text.
};

/// One line per node with branches in box-drawing characters; UTF-8, ends with a newline.
std::string tree_text(const Tree& tree, const TextOptions& options = {});

/// {"productions": [...], "applied": n, "nodes": [{"id", "parent", "symbol", "params", "text",
/// "path", "key", "production", ...}]} with nodes in the tree's order, indented by two spaces.
std::string tree_json(const Tree& tree);

struct SvgOptions {
  double font_size = 12;   ///< Pixels.
  double row = 24;         ///< Distance of neighbouring leaves, pixels.
  double column_gap = 36;  ///< Between the longest label of a generation and the next, pixels.
  double max_label = 48;   ///< Characters; longer labels are truncated with an ellipsis.
};

/// A drawing that grows to the right, with one column per generation. Symbols of the same name have
/// the same colour; rewritten symbols are bold. The tooltip of a label shows the node's path,
/// production and location.
std::string tree_svg(const Tree& tree, const SvgOptions& options = {});

}  // namespace vug::grammar
