// SPDX-License-Identifier: Apache-2.0
// Points along the legs of a network.
#pragma once

#include <vug/network/network.h>

namespace vug::network {

/// Points on the legs, every `spacing` metres along each branch (Reduction), starting half a
/// spacing after its first station, in the order of the branches. A branch shorter than the spacing
/// has one in its middle. Throws Error(bad_input) if the spacing is not positive, and
/// Error(too_large) for more than a million points.
std::vector<Vec3d> points_along(const Network& network, double spacing);

}  // namespace vug::network
