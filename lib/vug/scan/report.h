// SPDX-License-Identifier: Apache-2.0
// Reports of a scan as JSON, SVG and pictures.
#pragma once

#include <vug/scan/openings.h>

namespace vug::scan {

/// JSON with the cloud's points, the plane and its frame, the range image, the wall, and all
/// openings as {"kind", "rect": [x, y, width, height], "empty", "set_back"}: metres from the lower
/// left corner of the range image, y up; null for missing numbers. "doubts" lists quality warnings
/// as sentences.
std::string report_json(const PointCloud& cloud, const PlaneFit& plane, const RangeImage& range,
                        const SurfaceMap& map, const std::vector<Opening>& openings);

/// An SVG of the openings, `pixels` wide, over a picture of the same extent if one is given.
std::string openings_svg(const RangeImage& range, const std::vector<Opening>& openings,
                         const std::string& picture = {}, double pixels = 1000);

/// Linear R, G, B: the wall in greys and surfaces behind it in blues, brighter where nearer; pixels
/// without a return in red, outside in black.
image::Image picture_of(const RangeImage& range, const SurfaceMap& map);

}  // namespace vug::scan
