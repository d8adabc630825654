// SPDX-License-Identifier: Apache-2.0
// Decomposition of connected components into boxes.
#pragma once

#include <vug/scan/mask.h>

namespace vug::scan {

struct FilledBox {
  PixelBox box;
  int64_t pixels = 0;  ///< Number of its pixels that are on.
};

/// Decomposes a component into a few boxes that it fills well. A straight cut is made if the boxes
/// of the parts are smaller than the box of the whole by at least the share `gain` of its area and
/// the parts fill the share `fill` of theirs. This separates two windows under one sign, but keeps
/// the triangle of a gable whole.
std::vector<FilledBox> split(const Component& group, double gain = 0.15, double fill = 0.8);

}  // namespace vug::scan
