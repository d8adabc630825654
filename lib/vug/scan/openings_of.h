// What both ways of finding openings share.
#pragma once

#include <vug/scan/mask.h>
#include <vug/scan/openings.h>

namespace vug::scan {

/// Error(bad_input) for options out of range.
void require_sound(const OpeningOptions& options);

/// The groups of open pixels as boxes, those of a likely size.
std::vector<Opening> openings_of(const Mask& open, const RangeImage& range, const SurfaceMap& map,
                                 const OpeningOptions& options);

}  // namespace vug::scan
