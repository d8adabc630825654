// SPDX-License-Identifier: Apache-2.0
// Levels of water in the hollows of a network (barnes2014).
#pragma once

#include <vug/cells/links.h>

#include <vector>

namespace vug::cells {

/// For each cell, the level at which water over it stands: the lowest height, in metres, over which
/// all paths of links to the nearest outlet must rise. It equals `height` where water runs off, and
/// is constant over a pool: the height of its lowest crest. Every connected piece needs an outlet.
std::vector<float> fill_pools(const Links& links, const std::vector<float>& height,
                              const std::vector<uint8_t>& outlet);

}  // namespace vug::cells
