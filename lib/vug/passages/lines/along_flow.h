// SPDX-License-Identifier: Apache-2.0
// Noises in coordinates that follow the passages of a cave.
#pragma once

#include <vug/field/noise.h>
#include <vug/passages/lines/axis_lines.h>

#include <vector>

namespace vug::passages {

struct AlongFlowOptions {
  double stretch = 1;  ///< Factor of lengths along the flow, above 0.
  double blend = 0.1;  ///< Metres, above 0: see along_flow.
};

/// The noise n evaluated in coordinates of the passages: x downstream along the axis, y upwards
/// across it, z to its right, in metres, with x divided by `stretch`. Each line i has the linear
/// coordinates c_i, which continue those of the line before it on the axis, and
///   f(p) = sum w_i n(c_i(p)) / sum w_i,  w_i = exp(-d_i / blend),
/// with d_i the distance to the line; lines whose weight is below exp(-16) of the largest are
/// omitted. Where the lines on both sides of a place differ in direction, f is their mean. The
/// gradient of the weights adds sum w_i / (sum w) |n_i - f| / blend, at most half of the range of n
/// over `blend`, to the Lipschitz constant of n, which a stretch below 1 divides. At least one
/// line.
field::Noise along_flow(std::vector<AxisLine> lines, const field::Noise& noise,
                        const AlongFlowOptions& options);

}  // namespace vug::passages
