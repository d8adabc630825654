// SPDX-License-Identifier: Apache-2.0
// Joints of finite length, as lines in plan along which passages run.
#pragma once

#include <vug/base/rng.h>
#include <vug/karst/geology.h>
#include <vug/karst/segment_grid.h>

#include <vector>

namespace vug::karst {

/// Least distance of nearly parallel joints, in separations of passages.
inline constexpr double kTracesApart = 2;

/// The joints of all families in the bounds of the geology, at the height 0. The joints of a family
/// lie at irregular distances side by side and one behind the other, are about four spacings long,
/// and each has a direction of its own, from a normal distribution about the azimuth. A joint ends
/// where it would come nearer than `apart` metres to an earlier one at less than 35 degrees, and
/// disappears if less than a spacing remains. At most `most` joints are drawn.
std::vector<SegmentPiece> joint_traces(const Geology& geology, double apart, size_t most,
                                       RandomKey key);

}  // namespace vug::karst
