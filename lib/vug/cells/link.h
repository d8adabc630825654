// Which cells become neighbours.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/network.h>
#include <vug/cells/surface.h>

namespace vug::cells {

/// The network of cells at these places: brought into an order that follows space, and linked.
/// Each cell holds on to the `full` nearest of those within `reach` (metres, over the surface by
/// surface_distance2; of equally near ones to those first in the order). A link is made where both
/// hold on to each other, so links are mutual and nobody has more than `full`. Areas are shared out
/// of `area`, the surface's, by the squared length of links. `right` stays empty.
Network link(const std::vector<SurfacePoint>& places, const Surface& surface, double spacing,
             double reach, uint32_t full, Progress& progress = Progress::none());

}  // namespace vug::cells
