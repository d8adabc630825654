// Columns and rows of a grid's cells as lines come and go.
#pragma once

#include <vug/fit/model/sizes.h>
#include <vug/fit/move.h>

namespace vug::fit {

/// Whether node i is a grid that has windows, which may differ from cell to cell.
bool has_cells(const MoveContext& context, const TreeState& state, int i);

/// The grid with these windows in its cells, row after row from the top, instead of its own.
TreeState with_windows(const Model& model, TreeState state, int grid, const SizeChoice& choice);

/// A grid seen along x, where its lines are columns, or along y.
class GridAxis {
 public:
  GridAxis(const MoveContext& context, TreeState& state, int i, bool along_x);

  Node& grid;
  Lines& lines;
  int16_t& count;
  int room;    ///< Of the area, in pixels.
  int origin;  ///< Of the area in the picture.
  const inference::DiscreteDistribution& profile;
  bool regular;
  bool differing;  ///< Whether it has cells.
  int kinds = 0;   ///< Of windows.

  int at(int line) const { return lines[static_cast<size_t>(line)]; }
  int span() const { return at(count - 1) - at(0); }
  /// Puts the lines where those of a regular grid are.
  void space_evenly(int first, int span) { lines = even_lines(first, span, count); }

  /// Makes room for a line there, its cells empty; and takes one out.
  void insert_line(int line, int place);
  void remove_line(int line);
  /// Chooses, or tells as they are, the kinds of a line's cells: alike, as they mostly are, or
  /// each by itself. False where the latter came out alike, which has a way of its own.
  bool choose_cells(int line, Choices& choices);
  bool same_cells(int line, int other) const;
  void copy_cells(int from, int to);

  int across() const;  ///< Lines of the other axis.
  int kind(int line, int other) const;
  void set_kind(int line, int other, int kind);

 private:
  bool alike(int line) const;
  bool along_x_;
};

}  // namespace vug::fit
