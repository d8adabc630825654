// A derivation tree with whole numbers for parameters: what the sampler moves through.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vug::fit {

constexpr int kMaxLines = 16, kMaxKinds = 15;

/// Where columns, or rows, of a grid begin, from the left, or top, of its area; unused ones are 0.
using Lines = std::array<int16_t, kMaxLines>;
/// Lines of a regular grid: `span` from the first to the last, between them even to a pixel.
Lines even_lines(int first, int span, int count);
/// Even lines that are nearest to these.
Lines nearest_even(const Lines& lines, int count);
/// A grid's cells, a number for each row.
using Cells = std::array<uint64_t, kMaxLines>;

/// A node's parameters are those that the production above it gives it; the others are 0, so that
/// equal trees have equal bytes.
struct Node {
  int16_t symbol = 0;
  int16_t production = -1;  ///< That rewrote it; -1: none.
  int16_t size = 1;         ///< Nodes of its subtree, itself included.
  int8_t parent_op = -1;    ///< The Op of the production that it is a part of; -1: the root.
  int16_t extent = 0;       ///< Height of a row, width of a middle or an element, repetitions.
  int16_t x = 0, y = 0;     ///< Of a terminal: its left top corner in its area,
  int16_t width = 0, height = 0;  ///< and its size; of a grid's windows only the size.
  int16_t columns = 0, rows = 0;
  Lines left{}, top{};
  /// What stands in the cells of a grid whose windows differ, four bits a column: 0 nothing, else
  /// one more than the place of the window among the grid's parts.
  Cells cells{};

  int kind(int column, int row) const {
    return static_cast<int>(cells[static_cast<size_t>(row)] >> (4 * column) & 15u);
  }
  void set_kind(int column, int row, int kind) {
    uint64_t& bits = cells[static_cast<size_t>(row)];
    bits = (bits & ~(uint64_t{15} << (4 * column))) | static_cast<uint64_t>(kind) << (4 * column);
  }
  /// Its cells if the first kind stood in all of them.
  Cells full_cells() const;
  bool operator==(const Node&) const = default;
};

/// In preorder: a node's first part follows it, and the next part follows that one's subtree.
struct Tree {
  std::vector<Node> nodes;

  Node& operator[](int i) { return nodes[static_cast<size_t>(i)]; }
  const Node& operator[](int i) const { return nodes[static_cast<size_t>(i)]; }
  int size() const { return static_cast<int>(nodes.size()); }
  /// Index behind the subtree of node i.
  int end(int i) const { return i + (*this)[i].size; }
  /// The node above; -1 for the root.
  int parent(int i) const;
  int child_count(int i) const;
  /// The node's part of that number, from 0.
  int child(int i, int number) const;

  /// Puts the nodes, each without parts, below node i, which has none; it was rewritten by that
  /// production.
  void grow(int i, int production, const std::vector<Node>& parts);
  /// Takes away all below node i.
  void prune(int i);
  /// Puts one node without parts before place `at`, as a part of node i.
  void insert(int i, int at, const Node& node);
  /// Takes node `at`, a part of node i, with its subtree away.
  void erase(int i, int at);
  /// Puts a whole subtree in place of that of node i.
  void replace(int i, const std::vector<Node>& subtree);

  bool operator==(const Tree&) const = default;

 private:
  void resize_above(int i, int by);
};

}  // namespace vug::fit
