// What both ways of finding openings share.
#pragma once

#include <vug/scan/mask.h>
#include <vug/scan/openings.h>

namespace vug::scan {

/// Error(bad_input) for options out of range.
void require_valid(const OpeningOptions& options);

/// Half a width in pixels: the radius of a square that just closes it.
int closing_radius(double metres, const RangeImage& range);

/// The groups of open pixels as boxes, those of a likely size.
std::vector<Opening> extract_openings(const Mask& open, const RangeImage& range,
                                      const SurfaceMap& map, const OpeningOptions& options);

}  // namespace vug::scan
