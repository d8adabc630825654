// SPDX-License-Identifier: Apache-2.0
// The particle distribution of Luo et al. 2010 (cite luo2010bamboo).
#pragma once

#include <vug/flora/plot.h>

#include <vector>

namespace vug::flora {

/// Eq. 2-4: the weighted mean of the corners. It is inside their convex hull because weights must
/// be above 0; the paper allows any real number, which would put most points outside.
/// Error(bad_input) if the number of weights differs from that of the corners, or for a weight that
/// is 0, negative or not finite.
Vec2d weighted_point(const Corners& corners, const std::vector<double>& weights);

}  // namespace vug::flora
