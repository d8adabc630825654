// Pixels between the points of a sparse cloud.
#pragma once

#include <vug/scan/range_image.h>

namespace vug::scan {

/// Pixels without depth take that of the nearest pixel with points, where its middle is no farther
/// than `reach` pixels from theirs (of equally near ones the left, then the upper one's). Holes
/// that are wider stay holes, but shrink by the reach.
void inpaint(RangeImage& image, double reach);

}  // namespace vug::scan
