// SPDX-License-Identifier: Apache-2.0
// Steps shared by both methods of opening detection.
#pragma once

#include <vug/scan/mask.h>
#include <vug/scan/openings.h>

namespace vug::scan {

/// Error(bad_input) for options out of range.
void require_valid(const OpeningOptions& options);

/// Half a width in pixels: the radius of the smallest square that closes it.
int closing_radius(double metres, const RangeImage& range);

/// Bounding boxes of the connected components of open pixels whose size is plausible.
std::vector<Opening> extract_openings(const Mask& open, const RangeImage& range,
                                      const SurfaceMap& map, const OpeningOptions& options);

}  // namespace vug::scan
