// Trees to look at: text for a terminal, JSON for programs, SVG for people. The same tree gives
// the same bytes.
#pragma once

#include <vug/grammar/tree.h>

namespace vug::grammar {

struct TextOptions {
  bool provenance = true;  ///< Append the production and its place in the user's text.
};

/// One line for each node under unicode branches; UTF-8, ends with a newline.
std::string tree_text(const Tree& tree, const TextOptions& options = {});

/// {"productions": [...], "applied": n, "nodes": [{"id", "parent", "symbol", "params", "text",
/// "path", "key", "production", ...}]}: nodes in the tree's order, indented by two spaces.
std::string tree_json(const Tree& tree);

struct SvgOptions {
  double font_size = 12;   ///< Pixels.
  double row = 24;         ///< Distance of neighbouring leaves, pixels.
  double column_gap = 36;  ///< Between the longest label of a generation and the next, pixels.
  double max_label = 48;   ///< Longer labels are cut and end in an ellipsis, characters.
};

/// A drawing that grows to the right, one column for each generation; symbols of one name have one
/// colour, rewritten ones stand in bold. Hovering over a label tells the node's path, production
/// and place.
std::string tree_svg(const Tree& tree, const SvgOptions& options = {});

}  // namespace vug::grammar
