// SPDX-License-Identifier: Apache-2.0
// Outlines as radii about the axis of a passage, for sections between two that were measured.
#pragma once

#include <vug/passages/section.h>

#include <vector>

namespace vug::passages {

/// Metres from the origin to the outline at equal angles, counterclockwise from the direction of u.
using StarOutline = std::vector<double>;

/// The outline of a section, up to its first crossing where it is not star-shaped.
StarOutline star_outline(const Section& section);

/// The section whose radii are those of `a` for share 0 and those of `b` for share 1.
SectionPtr blended_section(const StarOutline& a, const StarOutline& b, double share);

}  // namespace vug::passages
