// A facade grammar as a sampler sees it: productions whose sizes and counts are free.
#pragma once

#include <string>
#include <vector>

namespace vug::fit {

/// What is seen in an area. Each has a lane of its own in supervised evidence.
enum class RegionType { wall, window, door, shop };
constexpr int kRegionTypes = 4;

/// What a production does with the area of its head.
enum class Op {
  rows,      ///< Ground floor and the part above it.
  repeat,    ///< One part, side by side several times.
  mirror,    ///< A side, its mirror image, and maybe a middle between them.
  grid,      ///< Columns and rows.
  elements,  ///< Parts of different width, side by side.
  windows,   ///< Of a grid: kinds of windows for its cells, and maybe a door.
  terminal,  ///< Of an element: what is in it.
};

struct SymbolInfo {
  std::string name;
  bool terminal = false;
  RegionType type = RegionType::wall;  ///< Of terminals.
  bool grid = false;
  bool regular = false;    ///< Grids: columns have one distance, and rows one.
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
  std::vector<std::vector<int>> by_head;  ///< Indices of productions by their heads.
  int axiom = 0;

  const Production& production(int i) const { return productions[static_cast<size_t>(i)]; }
  const SymbolInfo& symbol(int i) const { return symbols[static_cast<size_t>(i)]; }
  const std::vector<int>& productions_of(int s) const { return by_head[static_cast<size_t>(s)]; }
};

/// Fills `of`.
Rules indexed(Rules rules);

/// What bounds the space of trees.
struct Limits {
  int min_size = 4;    ///< Smallest width and height of anything, pixels.
  int max_lines = 16;  ///< Columns of a grid, and rows, at most kMostLines.
  int max_elements = 16;
  int max_repeats = 16;
  int max_kinds = 15;  ///< Kinds of windows in a grid, at most kMostKinds.
  int max_nodes = 64;  ///< Of a tree.
};

}  // namespace vug::fit
