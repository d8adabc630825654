// SPDX-License-Identifier: Apache-2.0
// A range image reduced to square cells, each with the median of its depths.
#pragma once

#include <vug/scan/range_image.h>

namespace vug::scan {

struct CellDepths {
  int side = 1;  ///< Side length of a cell in pixels.
  int across = 0, down = 0;
  /// Median depth of each cell in metres, row by row from the top; NaN without depths.
  std::vector<double> depths;

  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(across) + static_cast<size_t>(x);
  }
};

/// Cells of about `cell` metres. `only`, if it is not empty, has one entry per pixel; pixels with 0
/// are ignored.
CellDepths cell_depths(const RangeImage& range, double cell, const std::vector<uint8_t>& only = {});

}  // namespace vug::scan
