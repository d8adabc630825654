// What windows gain in the cells of a grid.
#pragma once

#include <vug/fit/evidence/folded_integral.h>
#include <vug/fit/model/sizes.h>

namespace vug::fit {

/// Of the grid's place, its door and what its windows look like; where its lines are is told.
class GridGains {
 public:
  GridGains(const Model& model, const Evidence& evidence, const TreeState& state, int grid);

  /// How far windows may reach to the right, or down.
  int room(bool along_x) const { return along_x ? usable_width(area_) : area_.height; }
  /// How large a window may be there until it comes to the next line, or to the border.
  WindowSize max_size(const Node& grid, int column, int row) const;
  /// Bits; 0 for one that has no room there or is hidden by the door.
  double gain(const Node& grid, int column, int row, const WindowSize& size) const;

 private:
  Area area_;
  FoldedIntegral integral_;
  Rect door_{};
};

}  // namespace vug::fit
