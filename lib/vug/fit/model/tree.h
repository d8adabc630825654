// SPDX-License-Identifier: Apache-2.0
// Derivation trees with integer parameters, the state space of the sampler.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vug::fit {

constexpr int kMaxLines = 16, kMaxKinds = 15;

/// Start of each column or row of a grid, from the left or top of its area; unused entries are 0.
using Lines = std::array<int16_t, kMaxLines>;
/// Evenly spaced lines of a regular grid, rounded to pixels; `span` is the distance from first to
/// last.
Lines even_lines(int first, int span, int count);
/// The evenly spaced lines nearest to these.
Lines nearest_even(const Lines& lines, int count);
/// A grid's cells, one word per row.
using Cells = std::array<uint64_t, kMaxLines>;

/// A node's parameters are those assigned by its parent's production; the others are 0, so that
/// equal trees have equal bytes.
struct Node {
  int16_t symbol = 0;
  int16_t production = -1;  ///< The production that rewrote it; -1: none.
  int16_t size = 1;         ///< Number of nodes of its subtree, including itself.
  int8_t parent_op = -1;    ///< The Op of the production that created it; -1: the root.
  /// Height of a row, width of a middle or an element, or number of repetitions.
  int16_t extent = 0;
  int16_t x = 0, y = 0;           ///< Terminals: upper left corner in the area.
  int16_t width = 0, height = 0;  ///< Terminals: size. Windows of a grid have only a size.
  int16_t columns = 0, rows = 0;
  Lines left{}, top{};
  /// Contents of the cells of a grid whose windows differ, four bits per column: 0 for empty, else
  /// 1 + the index of the window among the grid's children.
  Cells cells{};

  int kind(int column, int row) const {
    return static_cast<int>(cells[static_cast<size_t>(row)] >> (4 * column) & 15u);
  }
  void set_kind(int column, int row, int kind) {
    uint64_t& bits = cells[static_cast<size_t>(row)];
    bits = (bits & ~(uint64_t{15} << (4 * column))) | static_cast<uint64_t>(kind) << (4 * column);
  }
  /// The cells if all of them held the first kind.
  Cells full_cells() const;
  bool operator==(const Node&) const = default;
};

/// Nodes in preorder: a node is followed by its first child; each child's subtree is followed by
/// the next child.
struct Tree {
  std::vector<Node> nodes;

  Node& operator[](int i) { return nodes[static_cast<size_t>(i)]; }
  const Node& operator[](int i) const { return nodes[static_cast<size_t>(i)]; }
  int size() const { return static_cast<int>(nodes.size()); }
  /// Index one past the subtree of node i.
  int end(int i) const { return i + (*this)[i].size; }
  /// Parent of node i; -1 for the root.
  int parent(int i) const;
  int child_count(int i) const;
  /// The child with this index, from 0.
  int child(int i, int number) const;

  /// Adds children without descendants to node i, which has none, and records the production.
  void grow(int i, int production, const std::vector<Node>& parts);
  /// Removes all descendants of node i.
  void prune(int i);
  /// Inserts one node without descendants at index `at`, as a child of node i.
  void insert(int i, int at, const Node& node);
  /// Removes node `at`, a child of node i, with its subtree.
  void erase(int i, int at);
  /// Replaces the subtree of node i.
  void replace(int i, const std::vector<Node>& subtree);

  bool operator==(const Tree&) const = default;

 private:
  void resize_above(int i, int by);
};

}  // namespace vug::fit
