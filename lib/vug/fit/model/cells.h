// SPDX-License-Identifier: Apache-2.0
// Columns and rows of a grid's cells while lines are inserted and removed.
#pragma once

#include <vug/fit/model/sizes.h>
#include <vug/fit/move.h>

namespace vug::fit {

/// Whether node i is a grid with windows that may differ from cell to cell.
bool has_cells(const MoveContext& context, const TreeState& state, int i);

/// The grid with its windows replaced by the choice, cells row by row from the top.
TreeState with_windows(const Model& model, TreeState state, int grid, const SizeChoice& choice);

/// A grid along x, where its lines are columns, or along y, where they are rows.
class GridAxis {
 public:
  GridAxis(const MoveContext& context, TreeState& state, int i, bool along_x);

  Node& grid;
  Lines& lines;
  int16_t& count;
  int room;    ///< Extent of the area in pixels.
  int origin;  ///< Start of the area in the picture.
  const inference::DiscreteDistribution& profile;
  bool regular;
  bool differing;  ///< Whether the grid has cells of its own.
  int kinds = 0;   ///< Number of window kinds.

  int at(int line) const { return lines[static_cast<size_t>(line)]; }
  int span() const { return at(count - 1) - at(0); }
  /// Spaces the lines evenly as in a regular grid.
  void space_evenly(int first, int span) { lines = even_lines(first, span, count); }

  /// Inserts a line with empty cells; removes a line.
  void insert_line(int line, int place);
  void remove_line(int line);
  /// Chooses, or scores as they are, the kinds of a line's cells: all alike, the usual case, or one
  /// by one. False if individual choices come out alike, because that outcome has its own path.
  bool choose_cells(int line, Choices& choices);
  bool same_cells(int line, int other) const;
  void copy_cells(int from, int to);

  int across() const;  ///< Number of lines of the other axis.
  int kind(int line, int other) const;
  void set_kind(int line, int other, int kind);

 private:
  bool alike(int line) const;
  bool along_x_;
};

}  // namespace vug::fit
