// SPDX-License-Identifier: Apache-2.0
// Gain of windows in the cells of a grid.
#pragma once

#include <vug/fit/evidence/folded_integral.h>
#include <vug/fit/model/sizes.h>

namespace vug::fit {

/// Built from the grid's area, its door and the appearance of its windows; the lines are passed to
/// each call.
class GridGains {
 public:
  GridGains(const Model& model, const Evidence& evidence, const TreeState& state, int grid);

  /// Usable extent for windows to the right, or downwards.
  int room(bool along_x) const { return along_x ? usable_width(area_) : area_.height; }
  /// Largest window that fits in the cell before the next line or the border.
  WindowSize max_size(const Node& grid, int column, int row) const;
  /// Bits; 0 for a window that does not fit or is hidden by the door.
  double gain(const Node& grid, int column, int row, const WindowSize& size) const;

 private:
  Area area_;
  FoldedIntegral integral_;
  Rect door_{};
};

}  // namespace vug::fit
