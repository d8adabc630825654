// Boxes of groups of pixels, those taken apart that hang together by mistake.
#pragma once

#include <vug/scan/mask.h>

namespace vug::scan {

struct FilledBox {
  PixelBox box;
  int64_t pixels = 0;  ///< Of its box that are on.
};

/// A group as few boxes that it fills well: it is cut straight through where that spares the boxes
/// of the parts at least `gain` of the area that the whole's box has, as long as the parts fill
/// `fill` of theirs. Two windows under one sign come apart so, and a gable's triangle stays whole.
std::vector<FilledBox> split(const Component& group, double gain = 0.15, double fill = 0.8);

}  // namespace vug::scan
