// SPDX-License-Identifier: Apache-2.0
// The height above the floor of the nearest passage.
#pragma once

#include <vug/field/field.h>
#include <vug/passages/lines/axis_lines.h>

#include <vector>

namespace vug::passages {

/// p.y minus the height of the floor at p, in metres. The floor f is given on the lines and is
/// extended to space by the mean of the least and the greatest function with the slope k = 4 that
/// agree with it (mcshane1934extension):
///   F(p) = 1/2 min over q (f(q) + k |p - q|) + 1/2 max over q (f(q) - k |p - q|).
/// Across a line, F is the floor at the nearest point of it; between two passages, it changes
/// continuously within (difference of floors) / k metres. The Lipschitz constant is 1 + k. Where
/// the floor of a passage itself is steeper than k, it is smoothed. At least one line.
field::Field height_above_floor(std::vector<AxisLine> lines);

}  // namespace vug::passages
