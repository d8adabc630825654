// What a scan was found to hold, for people and programs.
#pragma once

#include <vug/scan/openings.h>

namespace vug::scan {

/// JSON: the cloud's points, the plane with its frame, the range image, the wall, and all openings
/// as {"kind", "rect": [x, y, width, height], "empty", "set_back"}: metres from the lower left
/// corner of the range image, y up; null where there is no number. "doubts" are sentences.
std::string report_json(const PointCloud& cloud, const PlaneFit& plane, const RangeImage& range,
                        const SurfaceMap& map, const std::vector<Opening>& openings);

/// The openings as a drawing of `pixels` across, over a picture of the same extent if its file is
/// named.
std::string openings_svg(const RangeImage& range, const std::vector<Opening>& openings,
                         const std::string& picture = {}, double pixels = 1000);

/// Linear R, G, B: the wall in greys and what is behind it in blues, each the brighter the
/// nearer; nothing in red and what is outside in black.
image::Image picture_of(const RangeImage& range, const SurfaceMap& map);

}  // namespace vug::scan
