// SPDX-License-Identifier: Apache-2.0
// A facade grammar as the sampler sees it, whose sizes and counts are free, and the limits of
// sizes, counts and window kinds.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace vug::fit {

/// The type of region seen in an area. Each has its own lane in supervised evidence.
enum class RegionType { wall, window, door, shop };
constexpr int kRegionTypes = 4;

/// Operation of a production on the area of its head.
enum class Op {
  rows,      ///< Ground floor and the part above it.
  repeat,    ///< One part, repeated side by side.
  mirror,    ///< A side, its mirror image, and optionally a middle between them.
  grid,      ///< Columns and rows.
  elements,  ///< Parts of different widths, side by side.
  windows,   ///< Window kinds for the cells of a grid, and optionally a door.
  terminal,  ///< Content of an element.
};

struct SymbolInfo {
  std::string name;
  bool terminal = false;
  RegionType type = RegionType::wall;  ///< Region type of a terminal.
  bool grid = false;
  bool regular = false;    ///< Grids: equal spacing of columns and of rows.
  bool identical = false;  ///< Grids: all cells hold the same window.
};

struct Production {
  int head = 0;
  Op op = Op::rows;
  std::vector<int> parts;  ///< Symbols: row and part above; side and middle; window and door; ...
};

struct Rules {
  std::vector<SymbolInfo> symbols;
  std::vector<Production> productions;
  std::vector<std::vector<int>> by_head;  ///< Indices of the productions of each head.
  int axiom = 0;

  const Production& production(int i) const { return productions[static_cast<size_t>(i)]; }
  const SymbolInfo& symbol(int i) const { return symbols[static_cast<size_t>(i)]; }
  const std::vector<int>& productions_of(int s) const { return by_head[static_cast<size_t>(s)]; }
};

/// Fills `by_head`.
Rules with_index(Rules rules);

/// Limits of the space of trees.
struct Limits {
  int min_size = 4;    ///< Smallest width and height of any part, pixels.
  int max_lines = 16;  ///< Columns and rows of a grid, at most kMaxLines.
  int max_elements = 16;
  int max_repeats = 16;
  int max_kinds = 15;  ///< Window kinds of a grid, at most kMaxKinds.
  int max_nodes = 64;  ///< Nodes of a tree.
  /// Largest distance of the lower edge of doors and shops from the lower border of the picture,
  /// and largest height of doors, pixels. By default any distance and height.
  int max_sill = std::numeric_limits<int>::max();
  int max_door_height = std::numeric_limits<int>::max();
};

}  // namespace vug::fit
