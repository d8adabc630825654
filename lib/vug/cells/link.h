// SPDX-License-Identifier: Apache-2.0
// Linking of neighbouring cells.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/network.h>
#include <vug/cells/surface.h>

namespace vug::cells {

/// Builds the network of cells at these points: sorts them along a space-filling order and links
/// them. Each cell selects the `full` nearest cells within `reach` (metres over the surface by
/// surface_distance2; ties are resolved by order). A link is created if both cells select each
/// other, so links are mutual and no cell has more than `full`. The surface's `area` is distributed
/// in proportion to the squared length of links. `right` remains empty.
Network link(const std::vector<SurfacePoint>& places, const Surface& surface, double spacing,
             double reach, uint32_t full, Progress& progress = Progress::none());

}  // namespace vug::cells
