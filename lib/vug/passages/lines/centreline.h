// SPDX-License-Identifier: Apache-2.0
// The distance to the axes of passages.
#pragma once

#include <vug/field/field.h>
#include <vug/passages/lines/axis_lines.h>

#include <vector>

namespace vug::passages {

/// The exact distance to the nearest line minus `radius`, both in metres. Inside tubes that
/// overlap, it is the distance to the wall of the deeper one. At least one line.
field::Field centreline(std::vector<AxisLine> lines, double radius);

}  // namespace vug::passages
