// SPDX-License-Identifier: Apache-2.0
// Inpainting of the pixels between the points of a sparse cloud.
#pragma once

#include <vug/scan/range_image.h>

namespace vug::scan {

/// Fills pixels without depth from the nearest pixel with points whose centre is at most `reach`
/// pixels away (of equally near ones the left, then the upper one). Wider holes remain but shrink
/// by the reach.
void inpaint(RangeImage& image, double reach);

}  // namespace vug::scan
